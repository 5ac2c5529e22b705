-- What standings, searches and trends ask for: whether a run counts, a number that is another one after each change of
-- results, and indices in the order in which pages are read.

ALTER TABLE odograph.result ADD COLUMN standing text NOT NULL DEFAULT 'pass'
  CHECK (standing IN ('pass', 'doubtful', 'bad', 'otherwise'));
GRANT SELECT (standing) ON odograph.result TO viewer;

DROP INDEX odograph.result_by_task, odograph.result_by_class, odograph.result_by_team, odograph.result_by_name,
  odograph.metric_by_value;
CREATE INDEX result_by_task ON odograph.result (task, held, trial, robot);
CREATE INDEX result_by_class ON odograph.result (class, held, trial, robot);
CREATE INDEX result_by_team ON odograph.result (shown_team, task, held);
CREATE INDEX result_by_time ON odograph.result (held, trial, robot);
-- What a text is searched in. Stored, for making it anew for each run found takes longer than finding them.
ALTER TABLE odograph.result ADD COLUMN searched text NOT NULL
  GENERATED ALWAYS AS (lower(name || ' ' || team || ' ' || shown_team)) STORED;
-- The extension may be there already, in another schema.
CREATE EXTENSION IF NOT EXISTS pg_trgm WITH SCHEMA odograph;
DO $text$
BEGIN
  EXECUTE (SELECT format('CREATE INDEX result_by_text ON odograph.result '
    'USING gin (searched %I.gin_trgm_ops)', n.nspname)
    FROM pg_extension e JOIN pg_namespace n ON n.oid = e.extnamespace WHERE e.extname = 'pg_trgm');
END
$text$;

-- The task of the run beside each of its metrics, so the standings of a task are one stretch of one index. Results are
-- replaced, never changed, so it is given once.
ALTER TABLE odograph.metric ADD COLUMN task text NOT NULL DEFAULT '';
UPDATE odograph.metric m SET task = r.task FROM odograph.result r WHERE r.trial = m.trial AND r.robot = m.robot;
CREATE INDEX metric_by_task ON odograph.metric (task, name) INCLUDE (trial, robot, unit, value, sigma, at_least);
CREATE FUNCTION odograph.give_task() RETURNS trigger LANGUAGE plpgsql
  SET search_path = pg_catalog, pg_temp AS $task$
BEGIN
  SELECT r.task INTO NEW.task FROM odograph.result r WHERE r.trial = NEW.trial AND r.robot = NEW.robot;
  NEW.task := coalesce(NEW.task, '');
  RETURN NEW;
END
$task$;
REVOKE ALL ON FUNCTION odograph.give_task FROM PUBLIC;
CREATE TRIGGER give_task BEFORE INSERT ON odograph.metric
  FOR EACH ROW EXECUTE FUNCTION odograph.give_task();

CREATE TABLE odograph.result_state (
  single boolean PRIMARY KEY DEFAULT true CHECK (single),
  number bigint NOT NULL);
INSERT INTO odograph.result_state (number) VALUES (0);
ALTER TABLE odograph.result_state ENABLE ROW LEVEL SECURITY;
CREATE POLICY all_read ON odograph.result_state FOR SELECT TO teacher, bench, viewer USING (true);
GRANT SELECT ON odograph.result_state TO teacher, bench, viewer;

-- Last in each transaction that changes results, so none waits for another one's in the other order.
CREATE FUNCTION odograph.count_change() RETURNS trigger LANGUAGE plpgsql SECURITY DEFINER
  SET search_path = pg_catalog, pg_temp AS $count$
BEGIN
  UPDATE odograph.result_state SET number = number + 1;
  RETURN NULL;
END
$count$;
REVOKE ALL ON FUNCTION odograph.count_change FROM PUBLIC;
CREATE TRIGGER count_change AFTER INSERT OR UPDATE OR DELETE OR TRUNCATE ON odograph.result
  FOR EACH STATEMENT EXECUTE FUNCTION odograph.count_change();
CREATE TRIGGER count_change AFTER INSERT OR UPDATE OR DELETE OR TRUNCATE ON odograph.metric
  FOR EACH STATEMENT EXECUTE FUNCTION odograph.count_change();

-- Whether the runs of a bench count, and what they score, which may change without them: p_standings is
-- [{trial, standing, scores{robot: {value, sigma}}}]. Trials that another bench published last stay as they are.
CREATE FUNCTION odograph.set_standings(p_bench uuid, p_standings jsonb) RETURNS void
  LANGUAGE plpgsql SET search_path = pg_catalog, pg_temp AS $standings$
BEGIN
  PERFORM pg_advisory_xact_lock(7309940813231);
  UPDATE odograph.result r SET standing = s.standing
    FROM jsonb_to_recordset(p_standings) AS s(trial uuid, standing text), odograph.document d
    WHERE d.uuid = s.trial AND d.bench = p_bench AND r.trial = s.trial AND r.standing <> s.standing;
  DELETE FROM odograph.metric m
    USING jsonb_to_recordset(p_standings) AS s(trial uuid, scores jsonb), odograph.document d
    WHERE d.uuid = s.trial AND d.bench = p_bench AND m.trial = s.trial AND m.name = 'score'
      AND s.scores->m.robot IS NULL;
  INSERT INTO odograph.metric AS m (trial, robot, name, unit, value, sigma, at_least)
    SELECT r.trial, r.robot, 'score', 'points', (s.scores->r.robot->>'value')::double precision,
      (s.scores->r.robot->>'sigma')::double precision, false
      FROM jsonb_to_recordset(p_standings) AS s(trial uuid, scores jsonb), odograph.document d, odograph.result r
      WHERE d.uuid = s.trial AND d.bench = p_bench AND r.trial = s.trial AND s.scores->r.robot IS NOT NULL
    ON CONFLICT (trial, robot, name) DO UPDATE SET value = excluded.value, sigma = excluded.sigma
      WHERE (m.value, m.sigma) IS DISTINCT FROM (excluded.value, excluded.sigma);
END
$standings$;
REVOKE ALL ON FUNCTION odograph.set_standings FROM PUBLIC;
GRANT EXECUTE ON FUNCTION odograph.set_standings TO teacher, bench;

INSERT INTO odograph.hub_version (version) VALUES (2);
