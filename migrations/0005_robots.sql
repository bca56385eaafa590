-- Which robot of the cell a demonstration was recorded from and which one made a motion. Files
-- come from none, and what was made while there was only one robot does not say.

ALTER TABLE demonstration ADD COLUMN robot TEXT;
ALTER TABLE reproduction ADD COLUMN robot TEXT;
