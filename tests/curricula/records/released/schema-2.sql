-- The records as schema 2 wrote them, as a dump. Never edited.
BEGIN TRANSACTION;
CREATE TABLE schema_version (version INTEGER NOT NULL);
INSERT INTO "schema_version" VALUES(2);
CREATE TABLE trials (id INTEGER PRIMARY KEY AUTOINCREMENT, finished_utc TEXT NOT NULL, curriculum_id TEXT NOT NULL, scenario_id TEXT NOT NULL, device_kind TEXT NOT NULL, trial_path TEXT NOT NULL, complete INTEGER NOT NULL, passed INTEGER NOT NULL, reasons TEXT NOT NULL, peak_tongue_force_n REAL NOT NULL, time_of_peak_tongue_force_s REAL NOT NULL, time_to_trachea_visible_s REAL, glottis_visible_max_percent REAL NOT NULL, peak_gum_force_n REAL NOT NULL, time_of_peak_gum_force_s REAL NOT NULL, attempt_time_s REAL NOT NULL, attempt_start_s REAL NOT NULL, time_over_force_limit_s REAL NOT NULL, time_over_target_s REAL NOT NULL, loop_rate_hz REAL NOT NULL, deadline_misses INTEGER NOT NULL, ticks INTEGER NOT NULL);
INSERT INTO "trials" VALUES(7,'2023-01-01T00:00:00Z','c','s','mouse','/a/b.vtrial',1,0,'["why"]',1.5,2.0,NULL,3.0,4.0,5.0,6.0,7.0,8.0,9.0,10.0,11,12);
INSERT INTO "trials" VALUES(9,'2023-02-01T00:00:00Z','c','s','touch','/a/c.vtrial',0,0,'[]',0.1,2.0,3.5,3.0,4.0,5.0,6.0,7.0,8.0,9.0,10.0,11,5000000000);
CREATE INDEX trials_by_time ON trials (finished_utc);
DELETE FROM "sqlite_sequence";
INSERT INTO "sqlite_sequence" VALUES('trials',9);
COMMIT;
