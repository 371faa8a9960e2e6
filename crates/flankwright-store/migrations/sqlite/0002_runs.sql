-- Runs of a server: what was asked, what became of it. `owner` is the server that carries it out; the letters of `state` are fixed.
-- `status` is the verdict of the document, which is too large to be read for a list.
CREATE TABLE run (
    id       INTEGER PRIMARY KEY,
    owner    TEXT NOT NULL,
    kind     TEXT NOT NULL,
    name     TEXT NOT NULL,
    job      TEXT NOT NULL,
    state    TEXT NOT NULL
        CHECK (state IN ('queued', 'running', 'done', 'failed', 'cancelled', 'interrupted')),
    created  TEXT NOT NULL,
    ended    TEXT,
    status   TEXT,
    document TEXT
) STRICT;
CREATE INDEX run_by_state ON run (state, id);

-- Files of a run, in the order of `place`: handed in with it, or written by it.
CREATE TABLE run_file (
    run       INTEGER NOT NULL REFERENCES run (id) ON DELETE CASCADE,
    handed_in INTEGER NOT NULL,
    name      TEXT NOT NULL,
    place     INTEGER NOT NULL,
    bytes     BLOB NOT NULL,
    PRIMARY KEY (run, handed_in, name)
) STRICT, WITHOUT ROWID;
