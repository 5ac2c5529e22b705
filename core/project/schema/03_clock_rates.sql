-- Clocks of cameras start apart and also drift apart.

ALTER TABLE recording ADD COLUMN clock_rate REAL NOT NULL DEFAULT 0;
ALTER TABLE trial ADD COLUMN sync_rate REAL NOT NULL DEFAULT 0;
ALTER TABLE trial ADD COLUMN sync_rate_sigma REAL NOT NULL DEFAULT 0;
