package org.toqa.store;

import java.time.Instant;
import java.util.List;
import java.util.UUID;
import org.junit.jupiter.api.BeforeEach;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.fleet.RobotRecord;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask;
import org.toqa.testbed.LabTask;

/** A fleet's store on a new database, with two robots and the tasks that a test adds. */
abstract class FleetDatabaseTest extends DatabaseTest {
  static final Instant AT = Instant.parse("2026-11-21T10:00:00.123Z");
  static final RobotRecord R1 =
      RobotRecord.direct("r1", "lab", "127.0.0.1", 7275, 5, "P1", true, null);
  static final RobotRecord R2 = RobotRecord.direct("r2", "lab", "host", 1, 2.5, null, false, null);

  JdbiFleetStore store;

  @BeforeEach
  void openStore() {
    store = new JdbiFleetStore(database.jdbi());
  }

  static TransportTask asked(String name, double load, String user, Instant at) {
    TaskPlace place = new TaskPlace(Vec2.ZERO, null);
    return new TransportTask(0, name, load, place, place, "lab", 0, null, null, user, at);
  }

  TransportTask added(TransportTask task) {
    return store.addTasks(List.of(new Submission(task, UUID.randomUUID()))).getFirst();
  }

  static TransportTask task(String name) {
    return LabTask.of(name, "ann", AT);
  }
}
