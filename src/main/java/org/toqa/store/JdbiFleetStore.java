package org.toqa.store;

import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.UUID;
import java.util.function.Consumer;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.generic.GenericType;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.ChargeRecord;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.Hold;
import org.toqa.fleet.Orderer;
import org.toqa.fleet.RobotMove;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.StoredRobot;
import org.toqa.fleet.TaskArchive;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Pose;
import org.toqa.mission.TransportTask;
import org.toqa.motion.PassingRoom;
import org.toqa.motion.Segment;

/** The fleet's store on H2 and on MySQL: robots, tasks, who executes what, drives and events. */
public final class JdbiFleetStore implements FleetStore, TaskArchive {
  private static final String OUT_OF_SERVICE = "out_of_service";
  private static final String HELD = "held";
  private static final String CARRIED = "carried";

  private final SqlExecutor sql;

  public JdbiFleetStore(Jdbi jdbi) {
    this.sql = new SqlExecutor(jdbi);
  }

  /** A change and what the history tells of it, in one transaction. */
  private void change(Consumer<Handle> change, List<EventRecord> events) {
    sql.inTransaction(
        h -> {
          change.accept(h);
          EventTable.addMissing(h, events);
          return null;
        });
  }

  // --- robots -----------------------------------------------------------------------------------

  @Override
  public List<StoredRobot> storedRobots() {
    return sql.withHandle(RobotTable::storedRobots);
  }

  @Override
  public void saveRobot(RobotRecord robot, List<EventRecord> events) {
    change(h -> RobotTable.save(h, robot), events);
  }

  @Override
  public boolean updateRobot(RobotRecord before, RobotRecord after, List<EventRecord> events) {
    return sql.inTransaction(
        h -> {
          boolean isUpdated = RobotTable.update(h, before, after);
          if (isUpdated) {
            EventTable.addMissing(h, events);
          }
          return isUpdated;
        });
  }

  @Override
  public void moveRobot(String robot, RobotMove move, double diameter, List<EventRecord> events) {
    change(h -> RobotTable.move(h, robot, move, diameter), events);
  }

  @Override
  public void removeRobot(String robot, List<EventRecord> events) {
    change(h -> RobotTable.remove(h, robot), events);
  }

  @Override
  public void saveService(String robot, boolean inService, List<EventRecord> events) {
    change(h -> RobotTable.saveFlag(h, OUT_OF_SERVICE, robot, !inService), events);
  }

  @Override
  public void saveGone(String robot, List<EventRecord> events) {
    change(
        h -> {
          RobotTable.saveFlag(h, OUT_OF_SERVICE, robot, true);
          RobotTable.forgetPlace(h, robot);
        },
        events);
  }

  @Override
  public void saveToldLoad(String robot, double kilograms) {
    sql.inTransaction(h -> RobotTable.saveToldLoad(h, robot, kilograms));
  }

  @Override
  public void savePlace(String robot, Pose pose, double diameter, long drive) {
    sql.inTransaction(h -> RobotTable.savePlace(h, robot, pose, diameter, drive));
  }

  @Override
  public void saveLocated(String robot) {
    change(h -> RobotTable.saveFlag(h, CARRIED, robot, false), List.of());
  }

  @Override
  public void saveHold(String robot, boolean held, List<EventRecord> events) {
    change(h -> RobotTable.saveFlag(h, HELD, robot, held), events);
  }

  @Override
  public void saveCharge(ChargeRecord record, List<EventRecord> events) {
    change(h -> RobotTable.saveCharge(h, record), events);
  }

  @Override
  public Optional<StoredDrive> drive(String robot) {
    return sql.withHandle(h -> DriveTable.drive(h, robot));
  }

  @Override
  public void saveDrive(String robot, StoredDrive drive) {
    sql.inTransaction(h -> DriveTable.save(h, robot, drive));
  }

  @Override
  public void saveDriveEnd(String robot, long seq, int from, List<Segment> segments) {
    sql.inTransaction(h -> DriveTable.saveEnd(h, robot, seq, from, segments));
  }

  @Override
  public void saveRoom(String robot, long seq, @Nullable PassingRoom room) {
    sql.inTransaction(h -> DriveTable.saveRoom(h, robot, seq, room));
  }

  @Override
  public void inOneTransaction(Runnable work) {
    sql.inOneTransaction(work);
  }

  // --- all robots, and those of a floor ---------------------------------------------------------

  @Override
  public Optional<Hold> pause() {
    return sql.withHandle(
        h ->
            h.createQuery("select user_name as \"user\", at as since from fleet_pause")
                .mapTo(Hold.class)
                .findOne());
  }

  @Override
  public void savePause(@Nullable Hold pause, List<EventRecord> events) {
    change(
        h -> {
          h.execute("delete from fleet_pause");
          if (pause != null) {
            h.createUpdate("insert into fleet_pause (id, user_name, at) values (1, :user, :since)")
                .bindMethods(pause)
                .execute();
          }
        },
        events);
  }

  @Override
  public Map<String, Hold> floorHolds() {
    return sql.withHandle(
        h ->
            h.createQuery("select floor, user_name as \"user\", at as since from floor_holds")
                .setMapKeyColumn("floor")
                .collectInto(new GenericType<Map<String, Hold>>() {}));
  }

  @Override
  public void saveFloorHold(String floor, @Nullable Hold hold, List<EventRecord> events) {
    change(
        h -> {
          h.execute("delete from floor_holds where floor = ?", floor);
          if (hold != null) {
            h.createUpdate(
                    "insert into floor_holds (floor, user_name, at) values (:floor, :user, :since)")
                .bind("floor", floor)
                .bindMethods(hold)
                .execute();
          }
        },
        events);
  }

  @Override
  public Map<String, String> floorAllocators() {
    return sql.withHandle(
        h ->
            h.createQuery("select floor, allocator from floor_allocators")
                .setMapKeyColumn("floor")
                .setMapValueColumn("allocator")
                .collectInto(new GenericType<Map<String, String>>() {}));
  }

  @Override
  public void saveFloorAllocator(
      String floor, @Nullable String allocator, List<EventRecord> events) {
    change(
        h -> {
          h.execute("delete from floor_allocators where floor = ?", floor);
          if (allocator != null) {
            h.execute(
                "insert into floor_allocators (floor, allocator) values (?, ?)", floor, allocator);
          }
        },
        events);
  }

  // --- tasks ------------------------------------------------------------------------------------

  @Override
  public List<OpenTask> openTasks() {
    return tasks("state not in ('DONE', 'FAILED', 'CANCELLED')");
  }

  @Override
  public List<OpenTask> tasksWithLeftLoads() {
    return tasks("state in ('CANCELLED', 'FAILED') and set_down_x is not null");
  }

  @Override
  public List<OpenTask> endedLegs() {
    return tasks(
        """
        state in ('DONE', 'FAILED', 'CANCELLED') and order_id in
          (select o.order_id from tasks o where o.awaits_previous
            and o.state not in ('DONE', 'FAILED', 'CANCELLED'))
        """);
  }

  private List<OpenTask> tasks(String condition) {
    return sql.withHandle(
        h ->
            TaskTable.withRobots(
                h,
                h.createQuery(
                        "select "
                            + TaskRow.COLUMNS
                            + " from tasks where "
                            + condition
                            + " order by id")
                    .mapTo(TaskRow.class)
                    .list(),
                TaskRow::toOpenTask));
  }

  @Override
  public List<TransportTask> addTasks(List<Submission> submissions) {
    return sql.inTransaction(
        h -> {
          Map<Orderer, Optional<Long>> owners = owners(h, submissions);
          List<TransportTask> stored =
              OrderTable.addNew(h, submissions).stream()
                  .map(
                      s ->
                          TaskTable.add(
                              h, s, Objects.requireNonNull(owners.get(orderer(s))).orElse(null)))
                  .toList();
          EventTable.addAll(h, stored.stream().map(EventRecord::added).toList());
          return stored;
        });
  }

  /** Everybody locks them in the order of their ids. */
  private static Map<Orderer, Optional<Long>> owners(Handle h, List<Submission> submissions) {
    Map<Orderer, Optional<Long>> owners = new HashMap<>();
    submissions.stream()
        .map(JdbiFleetStore::orderer)
        .distinct()
        .sorted(
            Comparator.comparing(
                Orderer::account, Comparator.nullsFirst(Comparator.naturalOrder())))
        .forEach(
            by ->
                owners.put(
                    by, Optional.ofNullable(AccountTable.ownerOfNew(h, by.name(), by.account()))));
    return owners;
  }

  private static Orderer orderer(Submission submission) {
    return new Orderer(submission.task().user(), submission.task().owner());
  }

  @Override
  public void withdrawTasks(Collection<UUID> keys) {
    sql.inTransaction(
        h -> {
          keys.forEach(key -> TaskTable.withdraw(h, key));
          return null;
        });
  }

  @Override
  public void checkAvailable() {
    sql.withHandle(h -> h.createQuery("select 1").mapTo(Integer.class).one());
  }

  @Override
  public void saveMissions(List<MissionChange> changes) {
    sql.inTransaction(
        h -> {
          // First of all these locks: what is read then is newer than another try that was cut off.
          changes.forEach(change -> TaskTable.saveState(h, change.mission(), change.at()));
          Set<Long> robots = new TreeSet<>(); // everybody locks them in this order
          for (MissionChange change : changes) {
            robots.addAll(TaskTable.robotsOf(h, change.mission().id()));
            TaskTable.saveAssignedRobots(h, change.mission());
            robots.addAll(TaskTable.robotsOf(h, change.mission().id()));
            EventTable.addMissing(h, change.events());
          }
          robots.forEach(robot -> TaskTable.saveAvailability(h, robot));
          return null;
        });
  }

  @Override
  public void saveExpectations(List<ExpectedDelivery> expectations) {
    sql.inTransaction(
        h -> {
          expectations.stream()
              .sorted(Comparator.comparingLong(ExpectedDelivery::task)) // everybody locks them so
              .forEach(expectation -> TaskTable.saveExpectation(h, expectation));
          return null;
        });
  }

  @Override
  public boolean deleteTask(long task, EventRecord event) {
    return sql.inTransaction(
        h -> {
          boolean isDeleted = TaskTable.delete(h, task);
          if (isDeleted) {
            EventTable.addAll(h, List.of(event));
          }
          return isDeleted;
        });
  }

  @Override
  public List<TaskView> tasks(Filter filter, Sort sort, int offset, int limit) {
    String order = TaskQuery.orderBy(sort) + " limit :limit offset :offset";
    return sql.withHandle(
        h ->
            TaskTable.withRobots(
                h,
                new TaskQuery(filter)
                    .select(h, TaskRow.COLUMNS, order)
                    .bind("limit", limit)
                    .bind("offset", offset)
                    .mapTo(TaskRow.class)
                    .list(),
                TaskRow::toView));
  }

  @Override
  public Optional<TaskView> task(long id) {
    return findTask("id", id);
  }

  @Override
  public Optional<TaskView> taskByKey(UUID key) {
    return findTask("submission", key);
  }

  private Optional<TaskView> findTask(String column, Object value) {
    return sql
        .withHandle(
            h ->
                TaskTable.withRobots(
                    h,
                    h.createQuery(
                            "select "
                                + TaskRow.COLUMNS
                                + " from tasks where "
                                + column
                                + " = :value")
                        .bind("value", value)
                        .mapTo(TaskRow.class)
                        .list(),
                    TaskRow::toView))
        .stream()
        .findFirst();
  }

  @Override
  public long count(Filter filter) {
    return sql.withHandle(
        h -> new TaskQuery(filter).select(h, "count(*)", "").mapTo(Long.class).one());
  }

  // --- events -----------------------------------------------------------------------------------

  @Override
  public void addEvents(List<EventRecord> events) {
    change(h -> {}, events);
  }

  @Override
  public List<EventRecord> history(long task) {
    return sql.withHandle(h -> EventTable.ofTask(h, task));
  }
}
