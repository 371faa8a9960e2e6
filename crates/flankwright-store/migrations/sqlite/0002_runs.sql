-- Runs of a server: what was asked, what became of it. `owner` is the server that carries it out; the letters of `state` are fixed. A
-- number is given once, also when its run is taken out: pages and clients keep it. `status` is the verdict of the document; it and the
-- request are large and stand last, so that lists need not read over them.
CREATE TABLE run (
    id       INTEGER PRIMARY KEY AUTOINCREMENT,
    owner    TEXT NOT NULL,
    kind     TEXT NOT NULL,
    name     TEXT NOT NULL,
    state    TEXT NOT NULL
        CHECK (state IN ('queued', 'running', 'done', 'failed', 'cancelled', 'interrupted')),
    created  TEXT NOT NULL,
    ended    TEXT,
    status   TEXT,
    job      TEXT NOT NULL,
    document TEXT
) STRICT;
CREATE INDEX run_by_state ON run (state, id);

-- Servers that carry runs out, and when each was last heard of, in seconds of the database's clock.
CREATE TABLE run_server (
    owner TEXT PRIMARY KEY,
    seen  INTEGER NOT NULL
) STRICT, WITHOUT ROWID;

-- Files of a run, in the order of `place`: handed in with it, or written by it.
CREATE TABLE run_file (
    run       INTEGER NOT NULL REFERENCES run (id) ON DELETE CASCADE,
    handed_in INTEGER NOT NULL,
    name      TEXT NOT NULL,
    place     INTEGER NOT NULL,
    bytes     BLOB NOT NULL,
    PRIMARY KEY (run, handed_in, name)
) STRICT, WITHOUT ROWID;
