-- What a part was measured by: how many files, and what was stated about them. Parts of earlier imports have no row here.
CREATE TABLE part_content (
    part   INTEGER PRIMARY KEY REFERENCES part (id) ON DELETE CASCADE,
    files  INTEGER NOT NULL,
    stated TEXT NOT NULL
) STRICT;

-- The files of a measurement, in the order of `place`, packed; `digest` and `size` are those of the bytes before they were packed.
CREATE TABLE part_file (
    part   INTEGER NOT NULL REFERENCES part_content (part) ON DELETE CASCADE,
    place  INTEGER NOT NULL,
    name   TEXT NOT NULL,
    digest TEXT NOT NULL,
    size   INTEGER NOT NULL,
    packed BLOB NOT NULL,
    PRIMARY KEY (part, place)
) STRICT;
