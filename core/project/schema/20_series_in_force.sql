-- Which observations are used. Undoing a tracking takes its series out of force; as raw measurements they stay.

CREATE TABLE series_in_force (series_id INTEGER PRIMARY KEY REFERENCES observation_series(id));

INSERT INTO series_in_force SELECT id FROM observation_series;
