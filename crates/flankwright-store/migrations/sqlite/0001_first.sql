-- Measured parts. A part is its file: the same bytes are the same part. `characteristics` is the number of its measured values.
CREATE TABLE part (
    id       INTEGER PRIMARY KEY,
    digest   TEXT NOT NULL UNIQUE,
    series   TEXT NOT NULL,
    name     TEXT NOT NULL,
    drawing  TEXT,
    measured TEXT,
    machine  TEXT,
    source   TEXT NOT NULL,
    document TEXT NOT NULL,
    characteristics INTEGER NOT NULL
) STRICT;
CREATE INDEX part_by_series ON part (series, measured, id);

-- What is measured: once for all parts.
CREATE TABLE characteristic (
    id        INTEGER PRIMARY KEY,
    name      TEXT NOT NULL,
    flank     TEXT CHECK (flank IN ('left', 'right')),
    tooth     INTEGER,
    statistic TEXT NOT NULL,
    unit      TEXT NOT NULL
) STRICT;
CREATE UNIQUE INDEX characteristic_once
    ON characteristic (name, coalesce(flank, ''), coalesce(tooth, -1), statistic, unit);

-- What was found on a part; `place` keeps the order of its record.
CREATE TABLE measured_value (
    part           INTEGER NOT NULL REFERENCES part (id) ON DELETE CASCADE,
    characteristic INTEGER NOT NULL REFERENCES characteristic (id),
    place          INTEGER NOT NULL,
    value          REAL NOT NULL,
    lower_limit    REAL,
    upper_limit    REAL,
    PRIMARY KEY (part, characteristic)
) STRICT, WITHOUT ROWID;

-- The catalogue of worms and dressers, in the order of `place`.
CREATE TABLE body (
    kind  TEXT NOT NULL CHECK (kind IN ('worm', 'dresser')),
    name  TEXT NOT NULL,
    place INTEGER NOT NULL,
    entry TEXT NOT NULL,
    PRIMARY KEY (kind, name)
) STRICT;

-- Plans. `result_digest` is that of the document without its times of computation.
CREATE TABLE plan (
    id            INTEGER PRIMARY KEY,
    job           TEXT NOT NULL,
    job_digest    TEXT NOT NULL,
    result_digest TEXT NOT NULL,
    status        TEXT NOT NULL,
    version       TEXT NOT NULL,
    document      TEXT NOT NULL,
    UNIQUE (job_digest, result_digest)
) STRICT;

-- Measurements of skiving tools, in the order in which they came.
CREATE TABLE tool_measurement (
    id     INTEGER PRIMARY KEY,
    tool   TEXT NOT NULL,
    record TEXT NOT NULL
) STRICT;
CREATE INDEX tool_measurement_by_tool ON tool_measurement (tool, id);
