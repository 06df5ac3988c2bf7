package org.toqa.testbed;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.toqa.geometry.Vec2;
import org.toqa.mission.Stop;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask;

/** A usual task on the floor lab, of which a test cares for little. */
public final class LabTask {
  private static final TaskPlace START = new TaskPlace(new Vec2(1, 1), null);
  private static final TaskPlace GOAL = new TaskPlace(new Vec2(2, 2), null);

  private LabTask() {}

  /** The same along three stops: a person at the second one, and a moment at the last. */
  public static TransportTask tour(String user, Instant at) {
    TransportTask task = of("tour", user, at);
    return task.withStops(
        List.of(
            Stop.at(START),
            new Stop(new TaskPlace(new Vec2(1.5, 1), "Mill"), true, null),
            new Stop(GOAL, true, Duration.ofSeconds(5))));
  }

  /** Without a load along two stops: a person at the first one, and it charges at the last. */
  public static TransportTask drive(String user, Instant at) {
    TaskPlace mill = new TaskPlace(new Vec2(1.5, 1), "Mill");
    return new TransportTask(0, "drive", 0, mill, GOAL, "lab", 0, null, null, user, at)
        .withStops(
            List.of(
                new Stop(mill, true, null),
                new Stop(GOAL, false, Duration.ofSeconds(9), new Stop.Charge("C1", 0.75))));
  }

  /** A box of 1 kg that was asked for then; its id is not known yet. */
  public static TransportTask of(String name, String user, Instant at) {
    return new TransportTask(0, name, 1, START, GOAL, "lab", 0, null, null, user, at);
  }
}
