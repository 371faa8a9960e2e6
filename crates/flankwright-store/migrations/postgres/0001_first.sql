-- Measured parts. A part is its file: the same bytes are the same part. `characteristics` is the number of its measured values.
CREATE TABLE part (
    id       BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
    digest   TEXT NOT NULL UNIQUE,
    series   TEXT NOT NULL,
    name     TEXT NOT NULL,
    drawing  TEXT,
    measured TEXT COLLATE "C",
    machine  TEXT,
    source   TEXT NOT NULL,
    document JSON NOT NULL,
    characteristics BIGINT NOT NULL
);
CREATE INDEX part_by_series ON part (series, measured, id);

-- What is measured: once for all parts.
CREATE TABLE characteristic (
    id        BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
    name      TEXT NOT NULL,
    flank     TEXT CHECK (flank IN ('left', 'right')),
    tooth     BIGINT,
    statistic TEXT NOT NULL,
    unit      TEXT NOT NULL
);
CREATE UNIQUE INDEX characteristic_once
    ON characteristic (name, coalesce(flank, ''), coalesce(tooth, -1), statistic, unit);

-- What was found on a part; `place` keeps the order of its record.
CREATE TABLE measured_value (
    part           BIGINT NOT NULL REFERENCES part (id) ON DELETE CASCADE,
    characteristic BIGINT NOT NULL REFERENCES characteristic (id),
    place          BIGINT NOT NULL,
    value          DOUBLE PRECISION NOT NULL,
    lower_limit    DOUBLE PRECISION,
    upper_limit    DOUBLE PRECISION,
    PRIMARY KEY (part, characteristic)
);

-- The catalogue of worms and dressers, in the order of `place`.
CREATE TABLE body (
    kind  TEXT NOT NULL CHECK (kind IN ('worm', 'dresser')),
    name  TEXT NOT NULL,
    place BIGINT NOT NULL,
    entry JSON NOT NULL,
    PRIMARY KEY (kind, name)
);

-- Plans. `result_digest` is that of the document without its times of computation.
CREATE TABLE plan (
    id            BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
    job           TEXT NOT NULL,
    job_digest    TEXT NOT NULL,
    result_digest TEXT NOT NULL,
    status        TEXT NOT NULL,
    version       TEXT NOT NULL,
    document      JSON NOT NULL,
    UNIQUE (job_digest, result_digest)
);

-- Measurements of skiving tools, in the order in which they came.
CREATE TABLE tool_measurement (
    id     BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
    tool   TEXT NOT NULL,
    record JSON NOT NULL
);
CREATE INDEX tool_measurement_by_tool ON tool_measurement (tool, id);
