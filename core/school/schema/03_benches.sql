-- The runs of one bench (the login that published them), in the order in which pages are read.

CREATE INDEX result_by_owner ON odograph.result (owner, held, trial, robot);

INSERT INTO odograph.hub_version (version) VALUES (3);
