package org.toqa.fleet;

import java.util.List;
import java.util.concurrent.CompletionStage;
import org.toqa.geometry.Pose;
import org.toqa.grid.FloorMap;

/**
 * The fleet's door for its users: wishes go in, stored answers come back, snapshots show the rest.
 *
 * <ol>
 *   <li>A wish is checked against floors and robots; a refusal is a value with a sentence.
 *   <li>An accepted wish is stored before its answer completes, so it survives a crash from then
 *       on.
 *   <li>What becomes of it is seen in {@link #feed}.
 * </ol>
 *
 * Any thread may call it. A stage fails only when the store does not answer.
 */
public interface Fleet {

  CompletionStage<Answer<TaskView>> submit(TaskOrder order, String user);

  CompletionStage<Answer<RobotView>> addRobot(RobotOrder order, String user);

  /** A person says where a robot is. */
  CompletionStage<Answer<RobotView>> locate(String robot, Pose pose, String user);

  /**
   * A person takes a robot out of service: it stops and gets no task. While it is connected it
   * stays an obstacle where it stands; if it is not, its cells become free.
   */
  CompletionStage<Answer<RobotView>> takeOutOfService(String robot, String user);

  /** A person puts a robot back in service: it goes on with what it was at. */
  CompletionStage<Answer<RobotView>> putInService(String robot, String user);

  /** All floors, the first one the default. */
  List<FloorMap> floors();

  SnapshotFeed feed();
}
