-- The point of a robot that is measured. Robots without a colour came with it, which older programs do not
-- read.

ALTER TABLE robot ADD COLUMN reference_forward_m REAL NOT NULL DEFAULT 0;
ALTER TABLE robot ADD COLUMN reference_left_m REAL NOT NULL DEFAULT 0;
