-- What is to be taught, and the examples that were shown for it.

CREATE TABLE task (
    id            TEXT    NOT NULL PRIMARY KEY,
    name          TEXT    NOT NULL CHECK (length(name) BETWEEN 1 AND 120),
    created_at_ms INTEGER NOT NULL,
    deleted_at_ms INTEGER
) STRICT;

CREATE TABLE demonstration (
    id            TEXT    NOT NULL PRIMARY KEY,
    task_id       TEXT    NOT NULL REFERENCES task (id),
    take          INTEGER NOT NULL CHECK (take >= 1),
    state         TEXT    NOT NULL CHECK (state IN
                  ('preparing', 'recording', 'recorded', 'kept', 'discarded', 'interrupted')),
    source        TEXT    NOT NULL CHECK (source IN ('hand_guiding', 'virtual_hand', 'file')),
    created_at_ms INTEGER NOT NULL,
    duration_us   INTEGER NOT NULL DEFAULT 0 CHECK (duration_us >= 0),
    samples       INTEGER NOT NULL DEFAULT 0 CHECK (samples >= 0),
    gaps          INTEGER NOT NULL DEFAULT 0 CHECK (gaps >= 0),
    note          TEXT,
    problem       TEXT,
    UNIQUE (task_id, take)
) STRICT;

-- One committed piece of a recording. `samples` holds `count` little-endian records of
-- at_us (u64) followed by `columns` f64 values: 6 joint angles in degrees, and for a
-- recording that came with tool positions also x, y, z in millimetres.
CREATE TABLE demonstration_chunk (
    demonstration_id TEXT    NOT NULL REFERENCES demonstration (id),
    seq              INTEGER NOT NULL CHECK (seq >= 0),
    first_us         INTEGER NOT NULL CHECK (first_us >= 0),
    count            INTEGER NOT NULL CHECK (count >= 1),
    columns          INTEGER NOT NULL CHECK (columns IN (6, 9)),
    samples          BLOB    NOT NULL,
    crc32            INTEGER NOT NULL,
    PRIMARY KEY (demonstration_id, seq)
) STRICT;

-- Stretches without samples. They are kept as gaps and never filled in.
CREATE TABLE demonstration_gap (
    demonstration_id TEXT    NOT NULL REFERENCES demonstration (id),
    at_us            INTEGER NOT NULL CHECK (at_us >= 0),
    length_us        INTEGER NOT NULL CHECK (length_us >= 0)
) STRICT;

CREATE INDEX demonstration_gap_by_demonstration ON demonstration_gap (demonstration_id);
