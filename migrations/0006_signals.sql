-- Signals of the controller (a gripper, a vacuum): what was done with them while a motion was
-- shown, and when a reproduction set them.

-- An event at 0 says how the signal stood when the demonstration began. The order of insertion
-- is the order of events at the same time.
CREATE TABLE demonstration_signal (
    id               INTEGER NOT NULL PRIMARY KEY,
    demonstration_id TEXT    NOT NULL REFERENCES demonstration (id),
    at_us            INTEGER NOT NULL CHECK (at_us >= 0),
    name             TEXT    NOT NULL CHECK (length(name) BETWEEN 1 AND 64),
    value            INTEGER NOT NULL CHECK (value IN (0, 1))
) STRICT;

CREATE INDEX demonstration_signal_by_demonstration ON demonstration_signal (demonstration_id);

-- `at_us` counts from the beginning of the motion, like the records; `late_s` is how long after
-- its time of the plan the controller had the signal.
CREATE TABLE reproduction_signal (
    id              INTEGER NOT NULL PRIMARY KEY,
    reproduction_id TEXT    NOT NULL REFERENCES reproduction (id),
    at_us           INTEGER NOT NULL CHECK (at_us >= 0),
    name            TEXT    NOT NULL CHECK (length(name) BETWEEN 1 AND 64),
    value           INTEGER NOT NULL CHECK (value IN (0, 1)),
    late_s          REAL    NOT NULL
) STRICT;

CREATE INDEX reproduction_signal_by_reproduction ON reproduction_signal (reproduction_id);
