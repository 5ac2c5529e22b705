-- Frames are turned as their files demand before they are measured. Unknown (NULL) for what older versions made,
-- which measured the frames of clips as they are stored.

ALTER TABLE recording ADD COLUMN orientation INTEGER;
ALTER TABLE registration ADD COLUMN upright INTEGER;
