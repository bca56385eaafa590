-- The flight record grows while the arm moves, tells more of each cycle, and has events beside it.

-- Layout 1 is described in 0003. Layout 2 holds `count` little-endian records of at_us (u64), plan
-- time in seconds (f64), six commanded and six measured joint angles in degrees (f64), six commanded
-- speeds in degrees per second (f32), utilisation in percent (f32, NaN when it is not known), messages
-- lost before it (u32), phase (u8: 0 approach, 1 motion, 2 settling, 3 stopping,
-- 4 paused) and bits (u8: 1 late,
-- 2 held, 4 limited, 8 motors on, 16 program running). The times of a chunk of layout 1 are not known.
ALTER TABLE reproduction_chunk ADD COLUMN layout INTEGER NOT NULL DEFAULT 1 CHECK (layout IN (1, 2));
ALTER TABLE reproduction_chunk ADD COLUMN first_us INTEGER CHECK (first_us >= 0);
ALTER TABLE reproduction_chunk ADD COLUMN last_us INTEGER CHECK (last_us >= first_us);

CREATE TABLE reproduction_event (
    reproduction_id TEXT    NOT NULL REFERENCES reproduction (id),
    position        INTEGER NOT NULL CHECK (position >= 0),
    at_us           INTEGER NOT NULL CHECK (at_us >= 0),
    code            TEXT    NOT NULL,
    message         TEXT    NOT NULL,
    PRIMARY KEY (reproduction_id, position)
) STRICT;

-- When the server took the arm over: the zero of the record's times.
ALTER TABLE reproduction ADD COLUMN armed_at_ms INTEGER;
-- JSON lists, one number per joint.
ALTER TABLE reproduction ADD COLUMN tracking_max_by_joint_deg TEXT;
ALTER TABLE reproduction ADD COLUMN tracking_rms_by_joint_deg TEXT;
-- Counted over the record.
ALTER TABLE reproduction ADD COLUMN cycles INTEGER;
ALTER TABLE reproduction ADD COLUMN cycles_lost INTEGER;
ALTER TABLE reproduction ADD COLUMN cycles_late INTEGER;
ALTER TABLE reproduction ADD COLUMN cycles_held INTEGER;
ALTER TABLE reproduction ADD COLUMN cycles_limited INTEGER;
