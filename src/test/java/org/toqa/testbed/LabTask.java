package org.toqa.testbed;

import java.time.Instant;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask;

/** A usual task on the floor lab, of which a test cares for little. */
public final class LabTask {
  private static final TaskPlace START = new TaskPlace(new Vec2(1, 1), null);
  private static final TaskPlace GOAL = new TaskPlace(new Vec2(2, 2), null);

  private LabTask() {}

  /** A box of 1 kg that was asked for then; its id is not known yet. */
  public static TransportTask of(String name, String user, Instant at) {
    return new TransportTask(0, name, 1, START, GOAL, "lab", 0, null, null, user, at);
  }
}
