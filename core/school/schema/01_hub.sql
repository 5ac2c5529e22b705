-- Documents of classes, teams, tasks and trials with their revisions, results as columns, and three roles. Nothing
-- here is for PUBLIC; row security says which rows a bench may change, column grants what a viewer may read.

DO $roles$
DECLARE wanted text;
BEGIN
  FOREACH wanted IN ARRAY ARRAY['teacher', 'bench', 'viewer'] LOOP
    IF NOT EXISTS (SELECT 1 FROM pg_roles WHERE rolname = wanted) THEN
      EXECUTE format('CREATE ROLE %I NOLOGIN', wanted);
    END IF;
  END LOOP;
END
$roles$;

CREATE SCHEMA odograph;
REVOKE ALL ON SCHEMA odograph FROM PUBLIC;

CREATE TABLE odograph.hub_version (version integer PRIMARY KEY, made timestamptz NOT NULL DEFAULT now());

CREATE SEQUENCE odograph.revision;

CREATE TABLE odograph.document (
  uuid uuid PRIMARY KEY,
  kind text NOT NULL CHECK (kind IN ('class', 'team', 'task', 'trial')),
  name text NOT NULL CHECK (length(name) BETWEEN 1 AND 200),
  bench uuid NOT NULL,
  owner name NOT NULL DEFAULT current_user,
  revision bigint NOT NULL UNIQUE,
  made timestamptz NOT NULL DEFAULT now(),
  removed boolean NOT NULL DEFAULT false,
  sha256 text NOT NULL CHECK (sha256 ~ '^[0-9a-f]{64}$'),
  body bytea NOT NULL CHECK (length(body) <= 268435456));

-- One class, team or task of a name: two benches that make the same one mean the same one.
CREATE UNIQUE INDEX document_named ON odograph.document (kind, lower(name)) WHERE kind <> 'trial' AND NOT removed;

-- The hub counts, whoever writes, and one at a time: revisions appear in their order.
CREATE FUNCTION odograph.count_revision() RETURNS trigger LANGUAGE plpgsql
  SET search_path = pg_catalog, pg_temp AS $count$
BEGIN
  PERFORM pg_advisory_xact_lock(7309940813231);
  NEW.revision := nextval('odograph.revision');
  NEW.made := now();
  RETURN NEW;
END
$count$;
REVOKE ALL ON FUNCTION odograph.count_revision FROM PUBLIC;
CREATE TRIGGER count_revision BEFORE INSERT OR UPDATE ON odograph.document
  FOR EACH ROW EXECUTE FUNCTION odograph.count_revision();

CREATE TABLE odograph.older_document (LIKE odograph.document, PRIMARY KEY (uuid, revision));

CREATE TABLE odograph.recording (
  trial uuid PRIMARY KEY REFERENCES odograph.document ON DELETE CASCADE,
  owner name NOT NULL DEFAULT current_user,
  body bytea NOT NULL CHECK (length(body) <= 268435456));

CREATE TABLE odograph.result (
  trial uuid NOT NULL REFERENCES odograph.document ON DELETE CASCADE,
  robot text NOT NULL,
  owner name NOT NULL DEFAULT current_user,
  name text NOT NULL,
  team text NOT NULL,
  shown_team text NOT NULL,
  class text NOT NULL,
  task text NOT NULL,
  held timestamptz NOT NULL,
  duration_s double precision NOT NULL,
  PRIMARY KEY (trial, robot));
CREATE INDEX result_by_task ON odograph.result (task, held);
CREATE INDEX result_by_class ON odograph.result (class, held);
CREATE INDEX result_by_team ON odograph.result (team, held);
CREATE INDEX result_by_name ON odograph.result (lower(name));

CREATE TABLE odograph.metric (
  trial uuid NOT NULL,
  robot text NOT NULL,
  name text NOT NULL,
  unit text NOT NULL,
  value double precision NOT NULL,
  sigma double precision,
  at_least boolean NOT NULL,
  PRIMARY KEY (trial, robot, name),
  FOREIGN KEY (trial, robot) REFERENCES odograph.result ON DELETE CASCADE);
CREATE INDEX metric_by_value ON odograph.metric (name, value);

ALTER TABLE odograph.document ENABLE ROW LEVEL SECURITY;
ALTER TABLE odograph.older_document ENABLE ROW LEVEL SECURITY;
ALTER TABLE odograph.recording ENABLE ROW LEVEL SECURITY;
ALTER TABLE odograph.result ENABLE ROW LEVEL SECURITY;
ALTER TABLE odograph.metric ENABLE ROW LEVEL SECURITY;

CREATE POLICY teacher_all ON odograph.document TO teacher USING (true) WITH CHECK (true);
CREATE POLICY teacher_all ON odograph.older_document TO teacher USING (true) WITH CHECK (true);
CREATE POLICY teacher_all ON odograph.recording TO teacher USING (true) WITH CHECK (true);
CREATE POLICY teacher_all ON odograph.result TO teacher USING (true) WITH CHECK (true);
CREATE POLICY teacher_all ON odograph.metric TO teacher USING (true) WITH CHECK (true);

CREATE POLICY bench_reads ON odograph.document FOR SELECT TO bench USING (true);
CREATE POLICY bench_adds ON odograph.document FOR INSERT TO bench WITH CHECK (owner = current_user);
CREATE POLICY bench_changes ON odograph.document FOR UPDATE TO bench
  USING (owner = current_user) WITH CHECK (owner = current_user);
CREATE POLICY bench_reads ON odograph.older_document FOR SELECT TO bench USING (owner = current_user);
CREATE POLICY bench_adds ON odograph.older_document FOR INSERT TO bench WITH CHECK (owner = current_user);
CREATE POLICY bench_own ON odograph.recording TO bench
  USING (owner = current_user)
  WITH CHECK (owner = current_user AND EXISTS
    (SELECT 1 FROM odograph.document d WHERE d.uuid = trial AND d.owner = current_user));
CREATE POLICY bench_reads ON odograph.result FOR SELECT TO bench USING (true);
CREATE POLICY bench_own ON odograph.result TO bench
  USING (owner = current_user)
  WITH CHECK (owner = current_user AND EXISTS
    (SELECT 1 FROM odograph.document d WHERE d.uuid = trial AND d.owner = current_user));
CREATE POLICY bench_reads ON odograph.metric FOR SELECT TO bench USING (true);
CREATE POLICY bench_own ON odograph.metric TO bench
  USING (EXISTS (SELECT 1 FROM odograph.result r WHERE r.trial = metric.trial AND r.owner = current_user))
  WITH CHECK (EXISTS (SELECT 1 FROM odograph.result r WHERE r.trial = metric.trial AND r.owner = current_user));

CREATE POLICY viewer_reads ON odograph.result FOR SELECT TO viewer USING (true);
CREATE POLICY viewer_reads ON odograph.metric FOR SELECT TO viewer USING (true);

GRANT USAGE ON SCHEMA odograph TO teacher, bench, viewer;
GRANT SELECT ON odograph.hub_version TO teacher, bench, viewer;
GRANT USAGE ON SEQUENCE odograph.revision TO teacher, bench;
GRANT SELECT, INSERT, UPDATE, DELETE ON odograph.document, odograph.older_document, odograph.recording,
  odograph.result, odograph.metric TO teacher;
GRANT SELECT, INSERT, UPDATE ON odograph.document TO bench;
GRANT SELECT, INSERT ON odograph.older_document TO bench;
GRANT SELECT, INSERT, UPDATE, DELETE ON odograph.recording, odograph.result, odograph.metric TO bench;
GRANT SELECT (trial, robot, shown_team, class, task, held, duration_s) ON odograph.result TO viewer;
GRANT SELECT ON odograph.metric TO viewer;

-- Takes in one document, whole or not at all. The later one wins; what it replaces is kept as an older revision. The
-- same document twice is one.
CREATE FUNCTION odograph.publish(p_uuid uuid, p_kind text, p_name text, p_bench uuid, p_base bigint, p_sha256 text,
  p_body bytea, p_recordings bytea, p_results jsonb, p_removed boolean)
  RETURNS TABLE (outcome text, kept_uuid uuid, kept_revision bigint, kept_owner name, other bytea)
  LANGUAGE plpgsql SET search_path = pg_catalog, pg_temp AS $publish$
DECLARE
  known odograph.document;
  coming bigint;
  holder name;
BEGIN
  PERFORM pg_advisory_xact_lock(7309940813231);
  SELECT * INTO known FROM odograph.document d WHERE d.uuid = p_uuid;
  IF known.uuid IS NULL AND p_kind <> 'trial' AND NOT p_removed THEN
    SELECT * INTO known FROM odograph.document d
      WHERE d.kind = p_kind AND lower(d.name) = lower(p_name) AND NOT d.removed;
  END IF;
  IF known.uuid IS NULL THEN
    IF p_removed THEN
      RETURN QUERY SELECT 'same'::text, p_uuid, 0::bigint, current_user::name, NULL::bytea;
      RETURN;
    END IF;
    holder := current_user;
    INSERT INTO odograph.document AS d (uuid, kind, name, bench, sha256, body)
      VALUES (p_uuid, p_kind, p_name, p_bench, p_sha256, p_body) RETURNING d.revision INTO coming;
    RETURN QUERY SELECT 'new'::text, p_uuid, coming, holder, NULL::bytea;
  ELSIF known.removed = p_removed AND (p_removed OR known.sha256 = p_sha256) THEN
    RETURN QUERY SELECT 'same'::text, known.uuid, known.revision, known.owner, NULL::bytea;
    RETURN;
  ELSE
    UPDATE odograph.document d SET name = CASE WHEN p_removed THEN d.name ELSE p_name END, bench = p_bench,
      removed = p_removed,
      sha256 = CASE WHEN p_removed THEN d.sha256 ELSE p_sha256 END,
      body = CASE WHEN p_removed THEN d.body ELSE p_body END
      WHERE d.uuid = known.uuid RETURNING d.revision INTO coming;
    IF NOT FOUND THEN
      RETURN QUERY SELECT 'refused'::text, known.uuid, known.revision, known.owner, known.body;
      RETURN;
    END IF;
    INSERT INTO odograph.older_document SELECT known.*;
    holder := known.owner;
    IF known.revision <> p_base AND NOT (p_base = 0 AND known.bench = p_bench) THEN
      RETURN QUERY SELECT 'conflict'::text, known.uuid, coming, holder, known.body;
    ELSE
      RETURN QUERY SELECT 'changed'::text, known.uuid, coming, holder, NULL::bytea;
    END IF;
  END IF;
  DELETE FROM odograph.result r WHERE r.trial = p_uuid;
  IF p_recordings IS NOT NULL THEN
    INSERT INTO odograph.recording (trial, owner, body) VALUES (p_uuid, holder, p_recordings)
      ON CONFLICT (trial) DO UPDATE SET body = excluded.body;
  END IF;
  INSERT INTO odograph.result (trial, robot, owner, name, team, shown_team, class, task, held, duration_s)
    SELECT p_uuid, r->>'robot', holder, r->>'name', r->>'team', r->>'shown_team', r->>'class', r->>'task',
      to_timestamp((r->>'held_ms')::double precision / 1000), (r->>'duration_s')::double precision
      FROM jsonb_array_elements(p_results) AS r;
  INSERT INTO odograph.metric (trial, robot, name, unit, value, sigma, at_least)
    SELECT p_uuid, r->>'robot', m->>'name', m->>'unit', (m->>'value')::double precision,
      (m->>'sigma')::double precision, (m->>'at_least')::boolean
      FROM jsonb_array_elements(p_results) AS r, jsonb_array_elements(r->'metrics') AS m
    ON CONFLICT DO NOTHING;
END
$publish$;
REVOKE ALL ON FUNCTION odograph.publish FROM PUBLIC;
GRANT EXECUTE ON FUNCTION odograph.publish TO teacher, bench;

INSERT INTO odograph.hub_version (version) VALUES (1);
