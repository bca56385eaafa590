-- Background work under a lease, and the models that it makes.

CREATE TABLE job (
    id             TEXT    NOT NULL PRIMARY KEY,
    kind           TEXT    NOT NULL CHECK (kind IN ('train_model')),
    task_id        TEXT    NOT NULL REFERENCES task (id),
    model_id       TEXT    NOT NULL,
    state          TEXT    NOT NULL CHECK (state IN
                   ('queued', 'running', 'succeeded', 'failed', 'cancelled')),
    unique_key     TEXT    NOT NULL,
    attempt        INTEGER NOT NULL DEFAULT 0,
    max_attempts   INTEGER NOT NULL,
    not_before_ms  INTEGER NOT NULL DEFAULT 0,
    lease_token    TEXT,
    lease_until_ms INTEGER,
    stage          TEXT    NOT NULL DEFAULT '',
    words          TEXT    NOT NULL DEFAULT '',
    done           INTEGER NOT NULL DEFAULT 0,
    total          INTEGER NOT NULL DEFAULT 0,
    fraction       REAL    NOT NULL DEFAULT 0,
    failure_code    TEXT,
    failure_message TEXT,
    failure_advice  TEXT,
    created_at_ms  INTEGER NOT NULL,
    started_at_ms  INTEGER,
    finished_at_ms INTEGER,
    CHECK ((state = 'running') = (lease_token IS NOT NULL)),
    CHECK ((lease_token IS NULL) = (lease_until_ms IS NULL))
) STRICT;

-- The same work asked for twice is the same job, unless the first one came to nothing.
CREATE UNIQUE INDEX job_unique_key ON job (unique_key)
    WHERE state IN ('queued', 'running', 'succeeded');
CREATE INDEX job_by_state ON job (state, created_at_ms);

CREATE TABLE model (
    id              TEXT    NOT NULL PRIMARY KEY,
    task_id         TEXT    NOT NULL REFERENCES task (id),
    version         INTEGER NOT NULL CHECK (version >= 1),
    state           TEXT    NOT NULL CHECK (state IN ('training', 'ready', 'failed', 'cancelled')),
    job_id          TEXT    NOT NULL REFERENCES job (id),
    method          TEXT    NOT NULL,
    seed            INTEGER NOT NULL,
    created_at_ms   INTEGER NOT NULL,
    summary         TEXT,
    report          TEXT,
    start_deg       TEXT,
    goal_deg        TEXT,
    duration_s      REAL,
    failure_code    TEXT,
    failure_message TEXT,
    failure_advice  TEXT,
    UNIQUE (task_id, version)
) STRICT;

CREATE TABLE model_source (
    model_id         TEXT    NOT NULL REFERENCES model (id),
    position         INTEGER NOT NULL,
    demonstration_id TEXT    NOT NULL REFERENCES demonstration (id),
    PRIMARY KEY (model_id, position)
) STRICT;

CREATE TABLE model_file (
    model_id TEXT NOT NULL PRIMARY KEY REFERENCES model (id),
    body     BLOB NOT NULL,
    sha256   TEXT NOT NULL
) STRICT;
