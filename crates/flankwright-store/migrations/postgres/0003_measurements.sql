-- What a part was measured by: how many files, and what was stated about them. Parts of earlier imports have no row here.
CREATE TABLE part_content (
    part   BIGINT PRIMARY KEY REFERENCES part (id) ON DELETE CASCADE,
    files  BIGINT NOT NULL,
    stated JSON NOT NULL
);

-- The files of a measurement, in the order of `place`, packed; `digest` and `size` are those of the bytes before they were packed.
CREATE TABLE part_file (
    part   BIGINT NOT NULL REFERENCES part_content (part) ON DELETE CASCADE,
    place  BIGINT NOT NULL,
    name   TEXT NOT NULL,
    digest TEXT NOT NULL,
    size   BIGINT NOT NULL,
    packed BYTEA NOT NULL,
    PRIMARY KEY (part, place)
);
