-- Motions that the arm really made, with what was commanded and what was measured.

CREATE TABLE reproduction (
    id                  TEXT    NOT NULL PRIMARY KEY,
    task_id             TEXT    NOT NULL REFERENCES task (id),
    model_id            TEXT    NOT NULL REFERENCES model (id),
    plan                TEXT    NOT NULL,
    state               TEXT    NOT NULL CHECK (state IN
                        ('running', 'succeeded', 'stopped', 'failed')),
    reason              TEXT,
    created_at_ms       INTEGER NOT NULL,
    finished_at_ms      INTEGER,
    start_deg           TEXT    NOT NULL,
    goal_deg            TEXT    NOT NULL,
    duration_s          REAL    NOT NULL,
    e_j_deg             REAL,
    e_j_commanded_deg   REAL,
    gmcc                REAL,
    tracking_mean_deg   REAL,
    tracking_max_deg    REAL,
    idempotency_key     TEXT    UNIQUE
) STRICT;

CREATE INDEX reproduction_by_task ON reproduction (task_id, created_at_ms);

-- `records` holds `count` little-endian records of at_us (u64), plan time in seconds (f64),
-- six commanded and six measured joint angles in degrees (f64).
CREATE TABLE reproduction_chunk (
    reproduction_id TEXT    NOT NULL REFERENCES reproduction (id),
    seq             INTEGER NOT NULL CHECK (seq >= 0),
    count           INTEGER NOT NULL CHECK (count >= 1),
    records         BLOB    NOT NULL,
    crc32           INTEGER NOT NULL,
    PRIMARY KEY (reproduction_id, seq)
) STRICT;
