-- Registrations with the picture in which their markers were seen.

ALTER TABLE registration ADD COLUMN picture_path TEXT NOT NULL DEFAULT '';
ALTER TABLE registration ADD COLUMN picture_sha256 TEXT NOT NULL DEFAULT '';
ALTER TABLE registration ADD COLUMN picture_bytes INTEGER NOT NULL DEFAULT 0;
