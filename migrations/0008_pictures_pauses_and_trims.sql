-- Photos of tasks, pauses within recordings, and takes whose ends are cut.

-- `kind` is what the first bytes of `body` say, never what somebody claimed.
CREATE TABLE task_picture (
    task_id TEXT NOT NULL PRIMARY KEY REFERENCES task (id),
    kind    TEXT NOT NULL CHECK (kind IN ('image/jpeg', 'image/png', 'image/webp')),
    body    BLOB NOT NULL CHECK (length(body) BETWEEN 1 AND 102400),
    sha256  TEXT NOT NULL
) STRICT;

-- A place where the recording was held up. The time that it took is closed up in the samples;
-- `length_us` says how long it was, and is missing when the recording ended in the pause.
CREATE TABLE demonstration_pause (
    id               INTEGER NOT NULL PRIMARY KEY,
    demonstration_id TEXT    NOT NULL REFERENCES demonstration (id),
    at_us            INTEGER NOT NULL CHECK (at_us >= 0),
    length_us        INTEGER CHECK (length_us >= 0)
) STRICT;

CREATE INDEX demonstration_pause_by_demonstration ON demonstration_pause (demonstration_id);

ALTER TABLE demonstration ADD COLUMN pauses INTEGER NOT NULL DEFAULT 0 CHECK (pauses >= 0);
-- JSON list, one angle per joint: where the arm was paused. Missing while it is not.
ALTER TABLE demonstration ADD COLUMN paused_at_deg TEXT;
-- The stretch of the recording that is used; all of it when missing. The samples stay.
ALTER TABLE demonstration ADD COLUMN trim_from_us INTEGER CHECK (trim_from_us >= 0);
ALTER TABLE demonstration ADD COLUMN trim_to_us INTEGER CHECK (trim_to_us > trim_from_us);

-- The stretch that the model was trained from, whatever is cut later.
ALTER TABLE model_source ADD COLUMN trim_from_us INTEGER CHECK (trim_from_us >= 0);
ALTER TABLE model_source ADD COLUMN trim_to_us INTEGER CHECK (trim_to_us > trim_from_us);
