package org.toqa.store;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Duration;
import java.time.Instant;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.UUID;
import java.util.stream.Collectors;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.ChargeRecord;
import org.toqa.fleet.ChargeRecord.Turn;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.Hold;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.StoredRobot;
import org.toqa.fleet.TaskArchive;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Vec2;
import org.toqa.link.trust.Fingerprint;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.LoadChoice;
import org.toqa.mission.Mission;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.mission.Trouble;

/** The fleet's store on H2 and on MySQL: robots, tasks, who executes what, drives and events. */
public final class JdbiFleetStore implements FleetStore, TaskArchive {
  private final SqlExecutor sql;

  public JdbiFleetStore(Jdbi jdbi) {
    this.sql = new SqlExecutor(jdbi);
  }

  // --- robots -----------------------------------------------------------------------------------

  @Override
  public List<StoredRobot> storedRobots() {
    return sql.withHandle(
        h ->
            h.createQuery(
                    """
                    select name, floor, host, port, max_load, parking, simulated, fingerprint,
                      out_of_service, held, worked_s, charger, charger_since
                    from robots where not removed order by id
                    """)
                .map((rs, ctx) -> storedRobot(rs))
                .list());
  }

  private static StoredRobot storedRobot(ResultSet rs) throws SQLException {
    String name = rs.getString("name");
    String charger = rs.getString("charger");
    return new StoredRobot(
        new RobotRecord(
            name,
            rs.getString("floor"),
            rs.getString("host"),
            rs.getInt("port"),
            rs.getDouble("max_load"),
            rs.getString("parking"),
            rs.getBoolean("simulated"),
            fingerprint(rs.getString("fingerprint"))),
        rs.getBoolean("out_of_service"),
        rs.getBoolean("held"),
        new ChargeRecord(
            name,
            Duration.ofMillis(Math.round(1000 * rs.getDouble("worked_s"))),
            charger == null ? null : new Turn(charger, Rows.instant(rs, "charger_since"))));
  }

  @Override
  public void saveRobot(RobotRecord robot) {
    sql.withHandle(
        h ->
            h.createUpdate(
                    """
                    insert into robots (name, floor, host, port, max_load, parking, simulated, fingerprint, availability, phase, last_seq)
                    values (:name, :floor, :host, :port, :maxLoad, :parking, :simulated, :fingerprint, 1, 0, 0)
                    on duplicate key update floor = values(floor), host = values(host), port = values(port),
                      max_load = values(max_load), parking = values(parking), simulated = values(simulated),
                      fingerprint = values(fingerprint),
                      out_of_service = case when removed then false else out_of_service end,
                      removed = false
                    """)
                .bind("name", robot.name())
                .bind("floor", robot.floor())
                .bind("host", robot.host())
                .bind("port", robot.port())
                .bind("maxLoad", robot.maxLoad())
                .bind("parking", robot.parking())
                .bind("simulated", robot.simulated())
                .bind("fingerprint", Objects.toString(robot.fingerprint(), null))
                .execute());
  }

  @Override
  public void removeRobot(String robot, List<EventRecord> events) {
    sql.inTransaction(
        h -> {
          h.createUpdate(
                  """
                  update robots set removed = true, out_of_service = true, held = false,
                    parking = null, charger = null, charger_since = null, worked_s = 0
                  where id = :id
                  """)
              .bind("id", robotId(h, robot))
              .execute();
          EventTable.addMissing(h, events);
          return null;
        });
  }

  private static @Nullable Fingerprint fingerprint(@Nullable String hex) {
    return hex == null ? null : new Fingerprint(hex);
  }

  @Override
  public void saveService(String robot, boolean inService, List<EventRecord> events) {
    saveFlag("out_of_service", robot, !inService, events);
  }

  @Override
  public void saveHold(String robot, boolean held, List<EventRecord> events) {
    saveFlag("held", robot, held, events);
  }

  private void saveFlag(String column, String robot, boolean value, List<EventRecord> events) {
    sql.inTransaction(
        h -> {
          h.createUpdate("update robots set " + column + " = :value where id = :id")
              .bind("value", value)
              .bind("id", robotId(h, robot))
              .execute();
          EventTable.addMissing(h, events);
          return null;
        });
  }

  @Override
  public void saveCharge(ChargeRecord record, List<EventRecord> events) {
    Turn turn = record.turn();
    sql.inTransaction(
        h -> {
          h.createUpdate(
                  """
                  update robots set worked_s = :worked, charger = :charger, charger_since = :since
                  where id = :id
                  """)
              .bind("worked", record.worked().toMillis() / 1000.0)
              .bind("charger", turn == null ? null : turn.point())
              .bind("since", turn == null ? null : SqlExecutor.utc(turn.since()))
              .bind("id", robotId(h, record.robot()))
              .execute();
          EventTable.addMissing(h, events);
          return null;
        });
  }

  @Override
  public Optional<Hold> pause() {
    return sql.withHandle(
        h ->
            h.createQuery("select user_name, at from fleet_pause")
                .map((rs, ctx) -> new Hold(rs.getString("user_name"), Rows.instant(rs, "at")))
                .findOne());
  }

  @Override
  public void savePause(@Nullable Hold pause, List<EventRecord> events) {
    sql.inTransaction(
        h -> {
          h.execute("delete from fleet_pause");
          if (pause != null) {
            h.createUpdate("insert into fleet_pause (id, user_name, at) values (1, :user, :at)")
                .bind("user", pause.user())
                .bind("at", SqlExecutor.utc(pause.since()))
                .execute();
          }
          EventTable.addMissing(h, events);
          return null;
        });
  }

  @Override
  public Map<String, Hold> floorHolds() {
    return sql.withHandle(
        h ->
            h.createQuery("select floor, user_name, at from floor_holds")
                .map(
                    (rs, ctx) ->
                        Map.entry(
                            rs.getString("floor"),
                            new Hold(rs.getString("user_name"), Rows.instant(rs, "at"))))
                .collect(Collectors.toMap(Map.Entry::getKey, Map.Entry::getValue)));
  }

  @Override
  public void saveFloorHold(String floor, @Nullable Hold hold, List<EventRecord> events) {
    sql.inTransaction(
        h -> {
          h.execute("delete from floor_holds where floor = ?", floor);
          if (hold != null) {
            h.createUpdate(
                    "insert into floor_holds (floor, user_name, at) values (:floor, :user, :at)")
                .bind("floor", floor)
                .bind("user", hold.user())
                .bind("at", SqlExecutor.utc(hold.since()))
                .execute();
          }
          EventTable.addMissing(h, events);
          return null;
        });
  }

  @Override
  public Optional<StoredDrive> drive(String robot) {
    return sql.withHandle(
        h ->
            h.createQuery(
                    """
                    select d.seq, d.task_id, d.phase, d.way
                    from drives d join robots r on r.id = d.robot_id where r.name = :robot
                    """)
                .bind("robot", robot)
                .map(
                    (rs, ctx) ->
                        new StoredDrive(
                            rs.getLong("seq"),
                            Rows.nullableLong(rs, "task_id"),
                            rs.getInt("phase"),
                            TrajectoryJson.read(rs.getString("way"))))
                .findOne());
  }

  @Override
  public void saveDrive(String robot, StoredDrive drive) {
    sql.inTransaction(
        h -> {
          long id = robotId(h, robot);
          h.createUpdate(
                  """
                  insert into drives (robot_id, seq, task_id, phase, way, created_at)
                  values (:id, :seq, :task, :phase, :way, :at)
                  on duplicate key update seq = values(seq), task_id = values(task_id), phase = values(phase),
                    way = values(way), created_at = values(created_at)
                  """)
              .bind("id", id)
              .bind("seq", drive.seq())
              .bind("task", drive.task())
              .bind("phase", drive.phase())
              .bind("way", TrajectoryJson.write(drive.trajectory()))
              .bind("at", SqlExecutor.utc(Instant.now()))
              .execute();
          return h.createUpdate("update robots set last_seq = :seq where id = :id")
              .bind("seq", drive.seq())
              .bind("id", id)
              .execute();
        });
  }

  private static long robotId(Handle h, String name) {
    return h.createQuery("select id from robots where name = :name")
        .bind("name", name)
        .mapTo(Long.class)
        .findOne()
        .orElseThrow(() -> new StoreException("There is no robot " + name + ".", null));
  }

  // --- tasks ------------------------------------------------------------------------------------

  private static final String TASK_COLUMNS =
      """
      id, name, user_name, floor, load_kg, load_length, load_width, start_x, start_y, start_station,
      goal_x, goal_y, goal_station, priority, deadline, state, created_at, changed_at, held, ending,
      set_down_x, set_down_y, trouble_robot, trouble_why, trouble_said, trouble_x, trouble_y, trouble_waits
      """;

  @Override
  public List<OpenTask> openTasks() {
    return sql.withHandle(
        h ->
            h
                .createQuery(
                    "select "
                        + TASK_COLUMNS
                        + " from tasks where state not in ('DONE', 'FAILED', 'CANCELLED') order by id")
                .map((rs, ctx) -> mapTask(rs))
                .list()
                .stream()
                .map(r -> new OpenTask(r.mission(h), r.changedAt()))
                .toList());
  }

  @Override
  public List<TransportTask> addTasks(List<Submission> submissions) {
    return sql.inTransaction(
        h -> {
          List<TransportTask> stored = submissions.stream().map(s -> add(h, s)).toList();
          EventTable.addAll(h, stored.stream().map(EventRecord::added).toList());
          return stored;
        });
  }

  private static TransportTask add(Handle h, Submission submission) {
    TransportTask task = submission.task();
    LoadSize size = task.size();
    long id =
        h.createUpdate(
                """
                      insert into tasks (name, user_id, user_name, floor, load_kg, load_length, load_width,
                        start_x, start_y, start_station, goal_x, goal_y, goal_station, priority, deadline,
                        state, created_at, changed_at, submission)
                      values (:name, (select id from users where name_key = :userKey), :user, :floor, :load,
                        :length, :width, :startX, :startY, :startStation, :goalX, :goalY, :goalStation,
                        :priority, :deadline, 'QUEUED', :at, :at, :submission)
                      """)
            .bind("name", task.name())
            .bind("userKey", task.user().toLowerCase(java.util.Locale.ROOT))
            .bind("user", task.user())
            .bind("floor", task.floor())
            .bind("load", task.load())
            .bind("length", size == null ? null : size.length())
            .bind("width", size == null ? null : size.width())
            .bind("startX", task.start().position().x())
            .bind("startY", task.start().position().y())
            .bind("startStation", task.start().station())
            .bind("goalX", task.goal().position().x())
            .bind("goalY", task.goal().position().y())
            .bind("goalStation", task.goal().station())
            .bind("priority", task.priority())
            .bind("deadline", task.deadline() == null ? null : SqlExecutor.utc(task.deadline()))
            .bind("at", SqlExecutor.utc(task.createdAt()))
            .bind("submission", submission.idempotencyKey().toString())
            .executeAndReturnGeneratedKeys("id")
            .mapTo(Long.class)
            .one();
    return task.withId(id);
  }

  @Override
  public void withdrawTasks(Collection<UUID> keys) {
    sql.inTransaction(
        h -> {
          keys.forEach(key -> withdraw(h, key));
          return null;
        });
  }

  private static void withdraw(Handle h, UUID key) {
    String of = " (select id from tasks where submission = :submission)";
    h.createUpdate("delete from events where task_id in" + of)
        .bind("submission", key.toString())
        .execute();
    h.createUpdate("delete from tasks where submission = :submission")
        .bind("submission", key.toString())
        .execute();
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
          changes.forEach(change -> saveState(h, change.mission(), change.at()));
          Set<Long> robots = new TreeSet<>(); // everybody locks them in this order
          for (MissionChange change : changes) {
            robots.addAll(robotsOf(h, change.mission().id()));
            saveAssignedRobots(h, change.mission());
            robots.addAll(robotsOf(h, change.mission().id()));
            EventTable.addMissing(h, change.events());
          }
          robots.forEach(robot -> saveAvailability(h, robot));
          return null;
        });
  }

  private static List<Long> robotsOf(Handle h, long task) {
    return h.createQuery("select robot_id from task_robots where task_id = :task")
        .bind("task", task)
        .mapTo(Long.class)
        .list();
  }

  private static void saveAssignedRobots(Handle h, Mission mission) {
    h.createUpdate("delete from task_robots where task_id = :id")
        .bind("id", mission.id())
        .execute();
    for (int place = 0; place < mission.assignedRobots().size(); place++) {
      saveAssignedRobot(h, mission.id(), place, mission.assignedRobots().get(place));
    }
  }

  /** From what the robot is in now: a task, the way home from one, or neither. */
  private static void saveAvailability(Handle h, long robot) {
    // availability 1: can be given a task; phase 0: parked   (Tanta, "Database")
    h.createUpdate(
            """
            update robots set
              availability = case when exists (select 1 from task_robots t
                where t.robot_id = :robot and not t.released and t.phase < 3) then 0 else 1 end,
              phase = coalesce((select min(t.phase) from task_robots t
                where t.robot_id = :robot and not t.released), 0)
            where id = :robot
            """)
        .bind("robot", robot)
        .execute();
  }

  private static void saveState(Handle h, Mission mission, Instant at) {
    TaskPlace setDown = mission.setDownPlace();
    Trouble trouble = mission.trouble();
    TaskPlace place = trouble == null ? null : trouble.place();
    h.createUpdate(
            """
            update tasks set state = :state, changed_at = :at, priority = :priority, held = :held, ending = :ending,
              assigned_at = coalesce(assigned_at, :assigned), delivered_at = coalesce(delivered_at, :delivered),
              set_down_x = :setDownX, set_down_y = :setDownY, trouble_robot = :troubleRobot,
              trouble_why = :troubleWhy, trouble_said = :troubleSaid, trouble_x = :troubleX,
              trouble_y = :troubleY, trouble_waits = :troubleWaits
            where id = :id
            """)
        .bind("state", mission.state().name())
        .bind("at", SqlExecutor.utc(at))
        .bind("priority", mission.task().priority())
        .bind("assigned", mission.state().isAssigned() ? SqlExecutor.utc(at) : null)
        .bind("delivered", mission.state().isDelivered() ? SqlExecutor.utc(at) : null)
        .bind("held", mission.held())
        .bind("ending", mission.ending() == null ? null : mission.ending().name())
        .bind("setDownX", setDown == null ? null : setDown.position().x())
        .bind("setDownY", setDown == null ? null : setDown.position().y())
        .bind("troubleRobot", trouble == null ? null : trouble.robot())
        .bind("troubleWhy", trouble == null ? null : trouble.why().english())
        .bind("troubleSaid", trouble == null ? null : SentenceJson.write(trouble.why()))
        .bind("troubleX", place == null ? null : place.position().x())
        .bind("troubleY", place == null ? null : place.position().y())
        .bind("troubleWaits", trouble != null && trouble.isAwaited())
        .bind("id", mission.id())
        .execute();
  }

  private static void saveAssignedRobot(Handle h, long task, int place, AssignedRobot carrier) {
    long robot = robotId(h, carrier.robot());
    h.createUpdate(
            """
            insert into task_robots (task_id, robot_id, place, phase, arrived, released)
            values (:task, :robot, :place, :phase, :arrived, :released)
            """)
        .bind("task", task)
        .bind("robot", robot)
        .bind("place", place)
        .bind("phase", carrier.phase())
        .bind("arrived", carrier.arrived())
        .bind("released", carrier.unassigned())
        .execute();
  }

  @Override
  public List<TaskView> tasks(Filter filter, Sort sort, int offset, int limit) {
    String order = TaskQuery.orderBy(sort) + " limit :limit offset :offset";
    return sql.withHandle(
        h ->
            new TaskQuery(filter)
                    .select(h, TASK_COLUMNS, order)
                    .bind("limit", limit)
                    .bind("offset", offset)
                    .map((rs, ctx) -> mapTask(rs))
                    .list()
                    .stream()
                    .map(r -> view(h, r))
                    .toList());
  }

  @Override
  public Optional<TaskView> task(long id) {
    return sql.withHandle(
        h ->
            h.createQuery("select " + TASK_COLUMNS + " from tasks where id = :id")
                .bind("id", id)
                .map((rs, ctx) -> mapTask(rs))
                .findOne()
                .map(r -> view(h, r)));
  }

  @Override
  public Optional<TaskView> taskByKey(UUID key) {
    return sql.withHandle(
            h ->
                h.createQuery("select id from tasks where submission = :key")
                    .bind("key", key.toString())
                    .mapTo(Long.class)
                    .findOne())
        .flatMap(this::task);
  }

  @Override
  public long count(Filter filter) {
    return sql.withHandle(
        h -> new TaskQuery(filter).select(h, "count(*)", "").mapTo(Long.class).one());
  }

  /**
   * @param missionWithoutRobots the mission without its robots
   */
  private record TaskRow(Mission missionWithoutRobots, Instant changedAt) {
    Mission mission(Handle h) {
      return new Mission(
          missionWithoutRobots.task(),
          missionWithoutRobots.state(),
          assignedRobots(h, missionWithoutRobots.id()),
          missionWithoutRobots.held(),
          missionWithoutRobots.ending(),
          missionWithoutRobots.setDownPlace(),
          missionWithoutRobots.trouble());
    }
  }

  private static TaskRow mapTask(ResultSet rs) throws SQLException {
    TransportTask task =
        new TransportTask(
            rs.getLong("id"),
            rs.getString("name"),
            rs.getDouble("load_kg"),
            new TaskPlace(
                new Vec2(rs.getDouble("start_x"), rs.getDouble("start_y")),
                rs.getString("start_station")),
            new TaskPlace(
                new Vec2(rs.getDouble("goal_x"), rs.getDouble("goal_y")),
                rs.getString("goal_station")),
            rs.getString("floor"),
            rs.getInt("priority"),
            Rows.nullableInstant(rs, "deadline"),
            Rows.loadSize(rs),
            rs.getString("user_name"),
            Rows.instant(rs, "created_at"));
    String ending = rs.getString("ending");
    Mission unmanned =
        new Mission(
            task,
            TaskState.valueOf(rs.getString("state")),
            List.of(),
            rs.getBoolean("held"),
            ending == null ? null : LoadChoice.valueOf(ending),
            mapPlace(rs, "set_down"),
            mapTrouble(rs));
    return new TaskRow(unmanned, Rows.instant(rs, "changed_at"));
  }

  private static @Nullable Trouble mapTrouble(ResultSet rs) throws SQLException {
    String robot = rs.getString("trouble_robot");
    return robot == null
        ? null
        : new Trouble(
            robot,
            SentenceJson.read(rs.getString("trouble_said"), rs.getString("trouble_why")),
            mapPlace(rs, "trouble"),
            rs.getBoolean("trouble_waits"));
  }

  private static @Nullable TaskPlace mapPlace(ResultSet rs, String columns) throws SQLException {
    Double x = Rows.nullableDouble(rs, columns + "_x");
    Double y = Rows.nullableDouble(rs, columns + "_y");
    return x == null || y == null ? null : new TaskPlace(new Vec2(x, y), null);
  }

  private static TaskView view(Handle h, TaskRow row) {
    return TaskView.of(row.mission(h), null, row.changedAt());
  }

  private static List<AssignedRobot> assignedRobots(Handle h, long task) {
    return h.createQuery(
            """
            select r.name, t.phase, t.arrived, t.released
            from task_robots t join robots r on r.id = t.robot_id where t.task_id = :task order by t.place
            """)
        .bind("task", task)
        .map(
            (rs, ctx) ->
                new AssignedRobot(
                    rs.getString("name"),
                    rs.getInt("phase"),
                    rs.getBoolean("arrived"),
                    rs.getBoolean("released")))
        .list();
  }

  // --- events -----------------------------------------------------------------------------------

  @Override
  public void addEvents(List<EventRecord> events) {
    sql.inTransaction(
        h -> {
          EventTable.addMissing(h, events);
          return null;
        });
  }

  @Override
  public List<EventRecord> history(long task) {
    return sql.withHandle(h -> EventTable.ofTask(h, task));
  }
}
