-- Each view is synchronised with the first one by its own method.

ALTER TABLE recording ADD COLUMN sync_method TEXT NOT NULL DEFAULT '';
ALTER TABLE recording ADD COLUMN start_offset_sigma_s REAL NOT NULL DEFAULT 0;

UPDATE recording SET sync_method=(SELECT sync_method FROM trial WHERE trial.id=trial_id)
    WHERE position>0;

UPDATE recording SET start_offset_sigma_s=(SELECT sync_offset_sigma_s FROM trial
    WHERE trial.id=trial_id) WHERE position=1;
