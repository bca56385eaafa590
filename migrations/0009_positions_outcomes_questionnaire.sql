-- What workers say: positions that they gave a name, whether a motion did its work, and what they
-- think of working with the arm.

-- Joint angles mean another place for another robot, so a position is one robot's. `joints_deg` is
-- a JSON list. One that is deleted stays, so that it can be said what became of it.
CREATE TABLE saved_position (
    id            TEXT    NOT NULL PRIMARY KEY,
    robot         TEXT    NOT NULL,
    name          TEXT    NOT NULL CHECK (length(name) BETWEEN 1 AND 80),
    joints_deg    TEXT    NOT NULL,
    created_at_ms INTEGER NOT NULL,
    deleted_at_ms INTEGER
) STRICT;

-- Two places of one robot under one name would be taken for each other.
CREATE UNIQUE INDEX saved_position_by_name ON saved_position (robot, name COLLATE NOCASE)
    WHERE deleted_at_ms IS NULL;

-- What a person saw, beside what the arm measured; nothing until somebody says so.
ALTER TABLE reproduction ADD COLUMN worked INTEGER CHECK (worked IN (0, 1));
ALTER TABLE reproduction ADD COLUMN outcome_note TEXT CHECK (length(outcome_note) BETWEEN 1 AND 400);
ALTER TABLE reproduction ADD COLUMN outcome_at_ms INTEGER;
-- A way back along another motion is no try at the task and does not count as one.
ALTER TABLE reproduction ADD COLUMN backwards INTEGER NOT NULL DEFAULT 0 CHECK (backwards IN (0, 1));

CREATE INDEX reproduction_by_time ON reproduction (created_at_ms);

-- `person` is a random identifier that a phone made for itself; nothing leads from it to a name.
-- The five answers run from 1 (not at all) to 5 (completely); all are missing when the person did
-- not want to answer.
CREATE TABLE questionnaire_reply (
    id              TEXT    NOT NULL PRIMARY KEY,
    person          TEXT    NOT NULL,
    task_id         TEXT    NOT NULL REFERENCES task (id),
    reproduction_id TEXT    REFERENCES reproduction (id),
    at_ms           INTEGER NOT NULL,
    learned         INTEGER CHECK (learned BETWEEN 1 AND 5),
    safe            INTEGER CHECK (safe BETWEEN 1 AND 5),
    accurate        INTEGER CHECK (accurate BETWEEN 1 AND 5),
    simple          INTEGER CHECK (simple BETWEEN 1 AND 5),
    enjoyable       INTEGER CHECK (enjoyable BETWEEN 1 AND 5),
    CHECK ((learned IS NULL) = (safe IS NULL)),
    CHECK ((learned IS NULL) = (accurate IS NULL)),
    CHECK ((learned IS NULL) = (simple IS NULL)),
    CHECK ((learned IS NULL) = (enjoyable IS NULL))
) STRICT;

CREATE INDEX questionnaire_reply_by_person ON questionnaire_reply (person, at_ms);
CREATE INDEX questionnaire_reply_by_task ON questionnaire_reply (task_id, at_ms);
