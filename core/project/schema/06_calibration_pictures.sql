-- Calibrations keep their source: the board, the detected corners, and the images.

ALTER TABLE intrinsics ADD COLUMN software_version TEXT NOT NULL DEFAULT '';
ALTER TABLE intrinsics ADD COLUMN board_pattern TEXT NOT NULL DEFAULT '';
ALTER TABLE intrinsics ADD COLUMN board_columns INTEGER NOT NULL DEFAULT 0;
ALTER TABLE intrinsics ADD COLUMN board_rows INTEGER NOT NULL DEFAULT 0;
ALTER TABLE intrinsics ADD COLUMN square_m REAL NOT NULL DEFAULT 0;
ALTER TABLE intrinsics ADD COLUMN marker_ratio REAL NOT NULL DEFAULT 0;
ALTER TABLE intrinsics ADD COLUMN dictionary TEXT NOT NULL DEFAULT '';
ALTER TABLE intrinsics ADD COLUMN lens_reason TEXT NOT NULL DEFAULT '';
ALTER TABLE intrinsics ADD COLUMN disagreeing_part REAL NOT NULL DEFAULT 0;
ALTER TABLE calibration_picture ADD COLUMN used INTEGER NOT NULL DEFAULT 1;
ALTER TABLE calibration_picture ADD COLUMN corners BLOB;
ALTER TABLE calibration_picture ADD COLUMN path TEXT NOT NULL DEFAULT '';
ALTER TABLE calibration_picture ADD COLUMN sha256 TEXT NOT NULL DEFAULT '';
ALTER TABLE calibration_picture ADD COLUMN bytes INTEGER NOT NULL DEFAULT 0;
