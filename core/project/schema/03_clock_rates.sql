-- Cameras' clocks do not only start apart, they drift apart as well.

ALTER TABLE recording ADD COLUMN clock_rate REAL NOT NULL DEFAULT 0;
ALTER TABLE trial ADD COLUMN sync_rate REAL NOT NULL DEFAULT 0;
ALTER TABLE trial ADD COLUMN sync_rate_sigma REAL NOT NULL DEFAULT 0;
