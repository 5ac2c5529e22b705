-- What a person gives the tracker of a recording: areas to search or to ignore, points set by hand, and when a robot
-- is not visible. A robot may be marked in several frames of a recording.

CREATE TABLE guidance (id INTEGER PRIMARY KEY, recording_id INTEGER NOT NULL REFERENCES recording(id),
    robot_id INTEGER REFERENCES robot(id), kind TEXT NOT NULL, from_frame INTEGER NOT NULL,
    to_frame INTEGER NOT NULL, points BLOB NOT NULL, sigma_px REAL NOT NULL);

ALTER TABLE pointed_out_robot RENAME TO pointed_out_once;

CREATE TABLE pointed_out_robot (recording_id INTEGER NOT NULL REFERENCES recording(id),
    robot_id INTEGER NOT NULL REFERENCES robot(id), frame INTEGER NOT NULL, x_px REAL NOT NULL,
    y_px REAL NOT NULL, PRIMARY KEY (recording_id, robot_id, frame));

INSERT INTO pointed_out_robot SELECT * FROM pointed_out_once;

DROP TABLE pointed_out_once;

-- The school's hub: what ties a project to it, by which identity the hub knows a row, and what is still to be
-- sent. The triggers note every change that the hub is to have, in the transaction that makes it, whoever writes; in a
-- project without a hub they do nothing.

CREATE TABLE school_link (id INTEGER PRIMARY KEY CHECK (id=1), url TEXT NOT NULL, bench TEXT NOT NULL,
    role TEXT NOT NULL, schema_version INTEGER NOT NULL, media TEXT NOT NULL, pulled INTEGER NOT NULL,
    last_sync_ms INTEGER);

CREATE TABLE school_document (kind TEXT NOT NULL, row_id INTEGER NOT NULL, uuid TEXT NOT NULL UNIQUE,
    revision INTEGER NOT NULL, sha256 TEXT NOT NULL, owner TEXT NOT NULL, views TEXT NOT NULL,
    PRIMARY KEY (kind, row_id));

CREATE TABLE school_outbox (kind TEXT NOT NULL, row_id INTEGER NOT NULL, removed TEXT NOT NULL DEFAULT '',
    mark INTEGER NOT NULL, UNIQUE (kind, row_id, removed));

CREATE TRIGGER school_trial_on_insert AFTER INSERT ON trial
    WHEN NEW.state='complete' AND EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark) SELECT 'trial', NEW.id, random(); END;

CREATE TRIGGER school_trial_on_update AFTER UPDATE ON trial
    WHEN NEW.state='complete' AND EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark) SELECT 'trial', NEW.id, random(); END;

CREATE TRIGGER school_trial_on_delete AFTER DELETE ON trial
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, removed, mark)
    SELECT kind, row_id, uuid, random() FROM school_document WHERE kind='trial' AND row_id=OLD.id;
    DELETE FROM school_document WHERE kind='trial' AND row_id=OLD.id;
    DELETE FROM school_outbox WHERE kind='trial' AND row_id=OLD.id AND removed=''; END;

CREATE TRIGGER school_class_on_delete AFTER DELETE ON class
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, removed, mark)
    SELECT kind, row_id, uuid, random() FROM school_document WHERE kind='class' AND row_id=OLD.id;
    DELETE FROM school_document WHERE kind='class' AND row_id=OLD.id;
    DELETE FROM school_outbox WHERE kind='class' AND row_id=OLD.id AND removed=''; END;

CREATE TRIGGER school_team_on_delete AFTER DELETE ON team
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, removed, mark)
    SELECT kind, row_id, uuid, random() FROM school_document WHERE kind='team' AND row_id=OLD.id;
    DELETE FROM school_document WHERE kind='team' AND row_id=OLD.id;
    DELETE FROM school_outbox WHERE kind='team' AND row_id=OLD.id AND removed=''; END;

CREATE TRIGGER school_task_on_delete AFTER DELETE ON task
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, removed, mark)
    SELECT kind, row_id, uuid, random() FROM school_document WHERE kind='task' AND row_id=OLD.id;
    DELETE FROM school_document WHERE kind='task' AND row_id=OLD.id;
    DELETE FROM school_outbox WHERE kind='task' AND row_id=OLD.id AND removed=''; END;

CREATE TRIGGER school_trial_robot_on_insert AFTER INSERT ON trial_robot
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE id=NEW.trial_id AND state='complete'; END;

CREATE TRIGGER school_trial_robot_on_update AFTER UPDATE ON trial_robot
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE id=NEW.trial_id AND state='complete'; END;

CREATE TRIGGER school_trial_robot_on_delete AFTER DELETE ON trial_robot
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE id=OLD.trial_id AND state='complete'; END;

CREATE TRIGGER school_trial_tag_on_insert AFTER INSERT ON trial_tag
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE id=NEW.trial_id AND state='complete'; END;

CREATE TRIGGER school_trial_tag_on_update AFTER UPDATE ON trial_tag
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE id=NEW.trial_id AND state='complete'; END;

CREATE TRIGGER school_trial_tag_on_delete AFTER DELETE ON trial_tag
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE id=OLD.trial_id AND state='complete'; END;

CREATE TRIGGER school_trial_variable_on_insert AFTER INSERT ON trial_variable
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE id=NEW.trial_id AND state='complete'; END;

CREATE TRIGGER school_trial_variable_on_update AFTER UPDATE ON trial_variable
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE id=NEW.trial_id AND state='complete'; END;

CREATE TRIGGER school_trial_variable_on_delete AFTER DELETE ON trial_variable
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE id=OLD.trial_id AND state='complete'; END;

CREATE TRIGGER school_overrule_on_insert AFTER INSERT ON overrule
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE id=NEW.trial_id AND state='complete'; END;

CREATE TRIGGER school_overrule_on_update AFTER UPDATE ON overrule
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE id=NEW.trial_id AND state='complete'; END;

CREATE TRIGGER school_overrule_on_delete AFTER DELETE ON overrule
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE id=OLD.trial_id AND state='complete'; END;

CREATE TRIGGER school_recording_on_insert AFTER INSERT ON recording
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE id=NEW.trial_id AND state='complete'; END;

CREATE TRIGGER school_recording_on_update AFTER UPDATE ON recording
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE id=NEW.trial_id AND state='complete'; END;

CREATE TRIGGER school_recording_on_delete AFTER DELETE ON recording
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE id=OLD.trial_id AND state='complete'; END;

CREATE TRIGGER school_imported_track_on_insert AFTER INSERT ON imported_track
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE id=NEW.trial_id AND state='complete'; END;

CREATE TRIGGER school_imported_track_on_delete AFTER DELETE ON imported_track
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE id=OLD.trial_id AND state='complete'; END;

CREATE TRIGGER school_analysis_on_insert AFTER INSERT ON analysis
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE id=NEW.trial_id AND state='complete'; END;

CREATE TRIGGER school_analysis_on_delete AFTER DELETE ON analysis
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE id=OLD.trial_id AND state='complete'; END;

CREATE TRIGGER school_class_on_insert AFTER INSERT ON class
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'class', NEW.id, random(); END;

CREATE TRIGGER school_class_on_update AFTER UPDATE ON class
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'class', NEW.id, random(); END;

CREATE TRIGGER school_team_on_insert AFTER INSERT ON team
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'team', NEW.id, random(); END;

CREATE TRIGGER school_team_on_update AFTER UPDATE ON team
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'team', NEW.id, random(); END;

CREATE TRIGGER school_task_on_insert AFTER INSERT ON task
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'task', NEW.id, random(); END;

CREATE TRIGGER school_task_on_update AFTER UPDATE ON task
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'task', NEW.id, random(); END;

CREATE TRIGGER school_team_member_on_insert AFTER INSERT ON team_member
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'team', id, random() FROM team WHERE id=NEW.team_id; END;

CREATE TRIGGER school_team_member_on_update AFTER UPDATE ON team_member
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'team', id, random() FROM team WHERE id=NEW.team_id; END;

CREATE TRIGGER school_team_member_on_delete AFTER DELETE ON team_member
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'team', id, random() FROM team WHERE id=OLD.team_id; END;

CREATE TRIGGER school_team_robot_on_insert AFTER INSERT ON team_robot
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'team', id, random() FROM team WHERE id=NEW.team_id; END;

CREATE TRIGGER school_team_robot_on_update AFTER UPDATE ON team_robot
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'team', id, random() FROM team WHERE id=NEW.team_id; END;

CREATE TRIGGER school_team_robot_on_delete AFTER DELETE ON team_robot
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'team', id, random() FROM team WHERE id=OLD.team_id; END;

CREATE TRIGGER school_gate_on_insert AFTER INSERT ON gate
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'task', id, random() FROM task WHERE id=NEW.task_id; END;

CREATE TRIGGER school_gate_on_update AFTER UPDATE ON gate
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'task', id, random() FROM task WHERE id=NEW.task_id; END;

CREATE TRIGGER school_gate_on_delete AFTER DELETE ON gate
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'task', id, random() FROM task WHERE id=OLD.task_id; END;

CREATE TRIGGER school_zone_on_insert AFTER INSERT ON zone
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'task', id, random() FROM task WHERE id=NEW.task_id; END;

CREATE TRIGGER school_zone_on_update AFTER UPDATE ON zone
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'task', id, random() FROM task WHERE id=NEW.task_id; END;

CREATE TRIGGER school_zone_on_delete AFTER DELETE ON zone
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'task', id, random() FROM task WHERE id=OLD.task_id; END;

CREATE TRIGGER school_scoring_on_insert AFTER INSERT ON scoring
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'task', id, random() FROM task WHERE id=NEW.task_id; END;

CREATE TRIGGER school_scoring_on_update AFTER UPDATE ON scoring
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'task', id, random() FROM task WHERE id=NEW.task_id; END;

CREATE TRIGGER school_scoring_on_delete AFTER DELETE ON scoring
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'task', id, random() FROM task WHERE id=OLD.task_id; END;

-- A trial carries the names of its team, class, task and robots, a team that of its class.

CREATE TRIGGER school_robot_renamed AFTER UPDATE OF name ON robot
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', trial.id, random() FROM trial JOIN trial_robot ON trial_id=trial.id
    WHERE robot_id=NEW.id AND state='complete';
    INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'team', team_id, random() FROM team_robot WHERE robot_id=NEW.id; END;

CREATE TRIGGER school_class_renamed AFTER UPDATE OF name ON class
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'team', id, random() FROM team WHERE class_id=NEW.id;
    INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', trial.id, random() FROM trial JOIN team ON team.id=team_id
    WHERE class_id=NEW.id AND state='complete'; END;

CREATE TRIGGER school_task_renamed AFTER UPDATE OF name ON task
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE task_id=NEW.id AND state='complete'; END;

CREATE TRIGGER school_team_changed AFTER UPDATE OF name, class_id, pseudonym ON team
    WHEN EXISTS (SELECT 1 FROM school_link)
    BEGIN INSERT OR REPLACE INTO school_outbox (kind, row_id, mark)
    SELECT 'trial', id, random() FROM trial WHERE team_id=NEW.id AND state='complete'; END;
