-- The range of a trial's time that its results are of; NULL: all of it. An analysis has the range that it was
-- measured by.

ALTER TABLE trial ADD COLUMN range_from_ns INTEGER;
ALTER TABLE trial ADD COLUMN range_to_ns INTEGER;

ALTER TABLE analysis ADD COLUMN range_from_ns INTEGER;
ALTER TABLE analysis ADD COLUMN range_to_ns INTEGER;
