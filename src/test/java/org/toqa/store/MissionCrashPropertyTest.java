package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.lifecycle.AfterProperty;
import net.jqwik.api.lifecycle.BeforeProperty;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetStore.OpenTask;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.fleet.RobotRecord;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.MissionEvents;
import org.toqa.mission.TransportTask;
import org.toqa.testbed.LabTask;
import org.toqa.testbed.Tally;

/** A server that is killed after any change goes on with its tasks as if it had not been. */
class MissionCrashPropertyTest {
  private final Database database = MemoryDatabase.open("crash-" + System.nanoTime());
  private long crashes;
  private long ended;

  @BeforeProperty
  void addRobots() {
    JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
    for (String robot : List.of("r1", "r2", "r3")) {
      store.saveRobot(RobotRecord.direct(robot, "lab", "127.0.0.1", 7275, 5, "P1", false, null));
    }
  }

  @AfterProperty
  void crashedOften() {
    database.close();
    Tally.add("crashes between two events of a task", crashes);
    assertTrue(crashes > 600 && ended > 10, crashes + " crashes, " + ended + " tasks ended");
  }

  /**
   * One life knows only what it last read: after each change it is stored, and what goes on is what
   * a new store reads. The other is never interrupted. They stay the same, and all that happened is
   * in the task's history, once and in its order.
   */
  @Property(tries = 400)
  void whatIsReadAfterACrashIsWhatWasLived(
      @ForAll("tasks") TransportTask ordered, @ForAll("events") List<MissionEvent> events) {
    UUID key = UUID.randomUUID();
    TransportTask task = added(ordered, key);
    liveTwice(task, events);
    new JdbiFleetStore(database.jdbi()).withdrawTasks(List.of(key));
  }

  private void liveTwice(TransportTask task, List<MissionEvent> events) {
    Mission lived = Mission.queued(task);
    Mission read = open(task).orElseThrow();
    List<String> told = new ArrayList<>(history(task));
    for (MissionEvent event : events) {
      lived = MissionEvents.givenToRobots(lived).apply(event).mission();
      Mission.Step step = MissionEvents.givenToRobots(read).apply(event);
      Mission next = step.mission();
      if (next.equals(read)) {
        assertEquals(lived, read);
        continue;
      }
      Instant at = FleetDatabaseTest.AT.plusSeconds(told.size());
      List<EventRecord> lines = EventRecord.of(step, event, at);
      lines.forEach(line -> told.add(line.kind() + ": " + line.text()));
      new JdbiFleetStore(database.jdbi()).saveMission(next, at, lines);
      crashes++;
      assertEquals(told, history(task));
      if (next.state().isEnded()) {
        assertEquals(Optional.empty(), open(task));
        assertEquals(lived.state(), state(task));
        ended++;
        return;
      }
      read = open(task).orElseThrow();
      assertEquals(lived, read, event::toString);
    }
  }

  private TransportTask added(TransportTask task, UUID key) {
    Submission submission = new Submission(task, key);
    return new JdbiFleetStore(database.jdbi()).addTasks(List.of(submission)).getFirst();
  }

  /** What a server that starts now finds. */
  private Optional<Mission> open(TransportTask task) {
    return new JdbiFleetStore(database.jdbi())
        .openTasks().stream()
            .map(OpenTask::mission)
            .filter(mission -> mission.task().id() == task.id())
            .findFirst();
  }

  private List<String> history(TransportTask task) {
    return new JdbiFleetStore(database.jdbi())
        .history(task.id()).stream().map(line -> line.kind() + ": " + line.text()).toList();
  }

  private Object state(TransportTask task) {
    return new JdbiFleetStore(database.jdbi()).task(task.id()).orElseThrow().state();
  }

  @Provide
  Arbitrary<TransportTask> tasks() {
    TransportTask box = LabTask.of("box", "ann", FleetDatabaseTest.AT);
    TransportTask tour = LabTask.tour("ann", FleetDatabaseTest.AT);
    TransportTask drive = LabTask.drive("ann", FleetDatabaseTest.AT);
    return Arbitraries.of(box, box, tour, drive);
  }

  @Provide
  Arbitrary<List<MissionEvent>> events() {
    return MissionEvents.upTo(40);
  }
}
