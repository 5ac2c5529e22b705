-- Registrations keep the image in which their markers were detected.

ALTER TABLE registration ADD COLUMN picture_path TEXT NOT NULL DEFAULT '';
ALTER TABLE registration ADD COLUMN picture_sha256 TEXT NOT NULL DEFAULT '';
ALTER TABLE registration ADD COLUMN picture_bytes INTEGER NOT NULL DEFAULT 0;
