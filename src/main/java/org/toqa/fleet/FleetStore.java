package org.toqa.fleet;

import java.time.Instant;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.mission.Mission;
import org.toqa.mission.OrderPart;
import org.toqa.mission.Phase;
import org.toqa.mission.TransportTask;
import org.toqa.motion.PassingRoom;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.persistence.StoreException;

/**
 * What the fleet must not forget.
 *
 * <ol>
 *   <li>At start the fleet reads {@link #storedRobots}, {@link #pause}, {@link #floorHolds}, {@link
 *       #openTasks} and each robot's {@link #drive}.
 *   <li>From then on every change is written here before the command that follows from it is sent.
 * </ol>
 *
 * Each call is one transaction, also those within {@link #inOneTransaction} together: when it
 * returns, a crash loses nothing of it; when it throws {@link StoreException}, it has happened as a
 * whole or not at all, and nobody knows which. It may then be repeated: what was stored twice is
 * stored once. Calls may wait; they come from virtual threads.
 */
public interface FleetStore {

  /** All robots that were added and not removed, in the order in which they were added. */
  List<StoredRobot> storedRobots();

  /** The records of {@link #storedRobots}. */
  default List<RobotRecord> robots() {
    return storedRobots().stream().map(StoredRobot::record).toList();
  }

  /** Whether all robots are paused. */
  Optional<Hold> pause();

  /** By name, the floors that are on hold. */
  Map<String, Hold> floorHolds();

  /** By name of a floor, the word of the allocator that a manager has chosen for it. */
  Map<String, String> floorAllocators();

  /** Tasks that have not ended, in the order in which they came. */
  List<OpenTask> openTasks();

  /** Ended tasks whose loads lie on the floor, in the order in which they came. */
  List<OpenTask> tasksWithLeftLoads();

  /** Of orders from stop to stop that have tasks which have not ended, those that have. */
  List<OpenTask> endedLegs();

  /** The last drive that was stored for the robot. */
  Optional<StoredDrive> drive(String robot);

  /**
   * Throws a {@link StoreException} of the kind {@code UNKNOWN_USER} where one of them is of a user
   * who may not log in, or is none any more.
   *
   * @param submissions those that are parts of a new order follow each other, its first part first
   * @return the tasks with their ids and those of their orders, in the same order
   */
  List<TransportTask> addTasks(List<Submission> submissions);

  /** Removes what {@link #addTasks} may have stored of them, as if nobody had asked for it. */
  void withdrawTasks(Collection<UUID> keys);

  /** Does nothing but throw when the store does not answer. */
  void checkAvailable();

  default void saveRobot(RobotRecord robot) {
    saveRobot(robot, List.of());
  }

  /** Adds the robot, or replaces the robot of that name, also a removed one. */
  void saveRobot(RobotRecord robot, List<EventRecord> events);

  /**
   * Changes a robot that is stored and not removed.
   *
   * @param before what the change was made of
   * @return false when the robot is not so any more; nothing has changed then
   */
  boolean updateRobot(RobotRecord before, RobotRecord after, List<EventRecord> events);

  /**
   * Forgets where the robot is and what it was at, but not which tasks it carried out. {@link
   * #saveRobot} brings it back, in service.
   */
  void removeRobot(String robot, List<EventRecord> events);

  /**
   * The robot belongs to another floor from now on, has no parking point there, and does not know
   * where it is until {@link #saveLocated}.
   *
   * @param move where it stands
   * @param diameter of the disc that it fills, metres
   */
  void moveRobot(String robot, RobotMove move, double diameter, List<EventRecord> events);

  /** Whether the robot is in service; a robot that was never taken out is. */
  void saveService(String robot, boolean inService, List<EventRecord> events);

  /** Takes the robot out of service and forgets its place: a person said that it is gone. */
  void saveGone(String robot, List<EventRecord> events);

  /**
   * The robot has stopped somewhere.
   *
   * @param pose map frame
   * @param diameter of the disc that it fills, metres
   * @param drive the number of its last drive, which has ended; 0: it had none
   */
  void savePlace(String robot, Pose pose, double diameter, long drive);

  /**
   * @param kilograms that the robot says it carries
   */
  void saveToldLoad(String robot, double kilograms);

  /** The robot was carried to its floor, and knows now where it stands there. */
  void saveLocated(String robot);

  void saveHold(String robot, boolean held, List<EventRecord> events);

  void saveCharge(ChargeRecord record, List<EventRecord> events);

  /**
   * @param pause null: the fleet goes on
   */
  void savePause(@Nullable Hold pause, List<EventRecord> events);

  /**
   * @param hold null: the floor's robots go on
   */
  void saveFloorHold(String floor, @Nullable Hold hold, List<EventRecord> events);

  /**
   * @param allocator its word; null: that of the configuration
   */
  void saveFloorAllocator(String floor, @Nullable String allocator, List<EventRecord> events);

  /** All of them, or none. */
  void saveMissions(List<MissionChange> changes);

  default void saveMission(Mission mission, Instant at, List<EventRecord> events) {
    saveMissions(List.of(new MissionChange(mission, at, events)));
  }

  /**
   * Keeps when tasks were expected to be delivered, for the statistics; what was kept of a task
   * before stays.
   */
  void saveExpectations(List<ExpectedDelivery> expectations);

  /**
   * Deletes a task that has ended and whose load does not lie on the floor; its events stay.
   *
   * @return false: it is no such task; nothing has changed then
   */
  boolean deleteTask(long task, EventRecord event);

  /** Replaces the robot's last drive, and remembers its sequence number. */
  void saveDrive(String robot, StoredDrive drive);

  /**
   * Replaces the end of the robot's last drive; what a drive before that was to be does not count.
   *
   * @param seq of the drive
   * @param from how many segments of it stay
   * @param segments that follow them, instead of those that followed
   * @throws StoreException it is refused where that drive is not stored
   */
  void saveDriveEnd(String robot, long seq, int from, List<Segment> segments);

  /**
   * Remembers the room beside the robot's last drive, until another drive is saved; that of a drive
   * before that does not count.
   *
   * @param seq of the drive
   * @param room null: there is none
   */
  void saveRoom(String robot, long seq, @Nullable PassingRoom room);

  /**
   * Makes one transaction of all that the work asks of this store on the thread that calls it. What
   * the work throws comes out of it, and nothing is stored then.
   */
  void inOneTransaction(Runnable work);

  void addEvents(List<EventRecord> events);

  /**
   * @param task its id is not known yet; its owner is the user who ordered it, or else whoever has
   *     his name
   * @param idempotencyKey names this submission, so that it can be withdrawn
   */
  record Submission(TransportTask task, UUID idempotencyKey) {
    public static Submission of(TransportTask task, Orderer by, UUID key) {
      return new Submission(task.withOwner(by.name(), by.account()), key);
    }

    /**
     * One of several that are ordered together.
     *
     * @param parts of all of them; empty: each is ordered by itself
     * @param keys of all of them
     */
    public static Submission of(
        TransportTask task,
        List<@Nullable OrderPart> parts,
        int index,
        Orderer by,
        List<UUID> keys) {
      return of(parts.isEmpty() ? task : task.withPart(parts.get(index)), by, keys.get(index));
    }
  }

  /**
   * When a task is expected to be delivered.
   *
   * @param hasRobots whether that was said when robots had just got it; else when it was ordered
   */
  record ExpectedDelivery(long task, boolean hasRobots, Instant delivery) {}

  /**
   * @param mission as it is from now on
   */
  record MissionChange(Mission mission, Instant at, List<EventRecord> events) {}

  /**
   * One that has not ended, whose load still lies on the floor, or for whose order more is to do.
   */
  record OpenTask(Mission mission, Instant changedAt) {}

  /**
   * @param seq of the robot link
   * @param task null when it drives for no task
   */
  record StoredDrive(long seq, @Nullable Long task, Phase phase, Trajectory trajectory) {}
}
