package org.toqa.fleet;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.CompletionStage;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FloorView.BoxView;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.link.gateway.GatewayState;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.OrderPart;
import org.toqa.mission.TransportTask;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Sentence;

/**
 * The fleet as its users see it: orders and commands go in, stored answers come back, snapshots
 * show the rest.
 *
 * <ol>
 *   <li>An order or command is checked against floors and robots; a refusal is a value with a
 *       sentence.
 *   <li>What is accepted is stored before its answer completes, so it survives a crash from then
 *       on.
 *   <li>What becomes of it is seen in {@link #snapshots}.
 * </ol>
 *
 * Any thread may call it. A stage fails only when the store does not answer.
 */
public interface Fleet {

  default CompletionStage<Answer<TaskView>> submit(TaskOrder order, String user) {
    return submit(order, user, UUID.randomUUID());
  }

  /** The same for who need not be a user. */
  default CompletionStage<Answer<TaskView>> submit(TaskOrder order, String user, UUID key) {
    return submit(order, Orderer.named(user), key);
  }

  /**
   * @param by a user who may not log in when it is stored, or is none any more, gets a {@link
   *     StoreException} of the kind {@code UNKNOWN_USER}
   * @param key by which the task is found again ({@link TaskArchive#taskByKey}); no task has it yet
   */
  CompletionStage<Answer<TaskView>> submit(TaskOrder order, Orderer by, UUID key);

  /** All these tasks, or none; each is ordered by itself. */
  default CompletionStage<BatchAnswer> submitAll(
      List<TaskOrder> orders, String user, List<UUID> keys) {
    return submitAll(orders, List.of(), Orderer.named(user), keys);
  }

  /**
   * All these tasks, or none.
   *
   * @param parts which part of an order each is, those of a new order from its first to its last,
   *     null where it is ordered by itself; empty: each is
   * @param by as of {@link #submit(TaskOrder, Orderer, UUID)}
   * @param keys one for each task; no task has one of them yet
   */
  CompletionStage<BatchAnswer> submitAll(
      List<TaskOrder> orders, List<@Nullable OrderPart> parts, Orderer by, List<UUID> keys);

  /**
   * Whether tasks with this key are being stored, or withdrawn again after their submission failed:
   * whether there will be one, nobody knows yet. While it is so no task that is found by the key
   * can be relied on, and nothing more is accepted with it.
   */
  boolean isSubmissionPending(UUID key);

  /** What {@link #submitAll} would say against these orders; nothing is stored. */
  CompletionStage<List<BatchAnswer.Rejection>> rejections(List<TaskOrder> orders, String user);

  /**
   * Decides by what would be said against an order. Until that is done the map of its floor does
   * not change, and the floor is not removed.
   *
   * @param decision what would be said, empty: nothing; it may wait, but for no floor
   */
  <T> CompletionStage<T> decide(
      TaskOrder order, String user, Function<Optional<BatchAnswer.Rejection>, T> decision);

  /** What would become of this task; nothing is stored. */
  CompletionStage<Answer<TaskPreview>> preview(TaskOrder order, String user);

  /** How a robot gets from here to there; nobody drives. */
  CompletionStage<Answer<PathAnswer>> path(PathQuestion question, String user);

  /** Through which robots can be reached, in the configuration's order. */
  List<GatewayState> gateways();

  CompletionStage<Answer<RobotView>> addRobot(RobotOrder order, String user);

  /**
   * A person pairs a robot with this server by the code that the robot shows. From then on it is
   * spoken to by no other key.
   */
  CompletionStage<Answer<RobotView>> pairRobot(String robot, PairingOrder order, String user);

  default CompletionStage<Answer<RobotView>> changeRobot(
      String robot, RobotChange change, String user) {
    return changeRobot(robot, change, null, user);
  }

  /**
   * @param seen what the user has seen of the robot: if it is not so any more, the change is
   *     outdated; null: whatever it is
   */
  CompletionStage<Answer<RobotView>> changeRobot(
      String robot, RobotChange change, @Nullable RobotChange seen, String user);

  /**
   * A person removes a robot that is out of service. The history keeps it, and adding a robot of
   * its name brings it back.
   */
  CompletionStage<Answer<RobotView>> removeRobot(String robot, String user);

  /**
   * A person has carried a robot that is out of service to another floor, and says where it stands.
   * It stays out of service, without a parking point.
   */
  CompletionStage<Answer<RobotView>> moveRobot(String robot, RobotMove move, String user);

  /** A person says where a robot is. */
  CompletionStage<Answer<RobotView>> locateRobot(String robot, Pose pose, String user);

  /**
   * A person takes a robot out of service: it stops and gets no task. While it is connected it
   * stays an obstacle where it is; if it is not, its cells become free.
   */
  CompletionStage<Answer<RobotView>> takeOutOfService(String robot, String user);

  /** A person puts a robot back in service: it goes on with what it was at. */
  CompletionStage<Answer<RobotView>> putInService(String robot, String user);

  /** A person puts a robot on hold: it stops where it is, and goes on when it is let go. */
  CompletionStage<Answer<RobotView>> holdRobot(String robot, String user);

  /** A person lets a robot go on that was put on hold. */
  CompletionStage<Answer<RobotView>> resumeRobot(String robot, String user);

  /**
   * A person has looked at a robot, and clears what its own hardware stopped it for; nothing else
   * clears that. The robot then waits for a new drive.
   *
   * @param reasons the codes of its clearable faults as the person was shown them; a conflict where
   *     they are others by now
   */
  CompletionStage<Answer<RobotView>> clearStops(String robot, Set<String> reasons, String user);

  /** A person sends a robot that has nothing to do to its parking point. */
  CompletionStage<Answer<RobotView>> sendHome(String robot, String user);

  /**
   * A robot that has nothing to do drives to a place, in the place of where it drove; a while after
   * it has come there it goes home by itself. Nothing of it is stored.
   *
   * @param place metres, map frame; a robot must be able to stand there
   */
  CompletionStage<Answer<RobotView>> sendTo(String robot, Vec2 place);

  /**
   * These boxes lie on a floor from now on, instead of those before: snapshots show them, and
   * robots keep off those that are not delivered, but for who fetches one. To be told again when
   * the floor's agents may be others. Nothing of it is stored.
   */
  void showBoxes(String floor, List<BoxView> boxes);

  /**
   * A person drives a robot by hand: a step more, which its floor's traffic grants or refuses. The
   * first one begins it, where nobody drives the robot and it has no task; the answer says what to
   * show with the next. A robot that nothing is said of stands within half a second, and drives by
   * itself again after ten.
   *
   * @param order its speeds at most {@link ManualOrder#MAX_SPEED} and {@link
   *     ManualOrder#MAX_TURN_RATE}, either way
   */
  CompletionStage<Answer<ManualAnswer>> driveByHand(String robot, ManualOrder order, String user);

  /** A person drives a robot by hand no longer; nothing where he does not. */
  CompletionStage<Answer<RobotView>> endManualDrive(String robot, UUID lease, String user);

  /** An operator command to a task: to cancel it, to hold it, to answer what it asks. */
  CompletionStage<Answer<TaskView>> commandTask(long task, MissionEvent.OperatorCommand command);

  /**
   * A person orders something else of a task that no robot has.
   *
   * @param seen what he has seen of the task: if its order is not so any more, the change is
   *     outdated; null: whatever it is
   */
  CompletionStage<Answer<TaskView>> editTask(
      long task, TaskOrder order, @Nullable TransportTask seen, String user);

  /**
   * A person deletes a task that has ended: it is in no list and in no statistics any more. What
   * the history says of it stays.
   */
  CompletionStage<Answer<TaskView>> deleteTask(TaskView task, String user);

  /** All robots hold, those that connect later too. No safety function. */
  CompletionStage<Answer<Optional<Hold>>> pauseAll(String user);

  CompletionStage<Answer<Optional<Hold>>> resumeAll(String user);

  /** All robots of a floor hold, those that connect later too. No safety function. */
  CompletionStage<Answer<Optional<Hold>>> holdFloor(String floor, String user);

  CompletionStage<Answer<Optional<Hold>>> resumeFloor(String floor, String user);

  /**
   * Who decides on a floor which robots carry what, from its next round on.
   *
   * @param allocator its word; empty: that of the configuration
   */
  CompletionStage<Answer<Optional<String>>> chooseAllocator(
      String floor, Optional<String> allocator, String user);

  Schedules schedules();

  /** How its floors are drawn. */
  FloorEditing floorEditing();

  /** All floors, the first one the default. */
  List<FloorMap> floors();

  /** The failures are among the alerts of its snapshots, within a second. */
  SnapshotFeed snapshots();

  /** The same of one floor alone; empty: there is no such floor. */
  Optional<SnapshotFeed> snapshots(String floor);

  /** Why that floor cannot go on by itself; empty while it can. Any thread may ask. */
  default List<Sentence> failures(String floor) {
    return List.of();
  }

  /** Why the fleet cannot go on by itself; empty while it can. Any thread may ask. */
  List<Sentence> failures();

  /** Which alerts ask something of people while the fleet itself goes on. Any thread may ask. */
  List<Sentence> advice();
}
