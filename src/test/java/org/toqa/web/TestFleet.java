package org.toqa.web;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.BatchAnswer;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.FloorView.FaultyCharger;
import org.toqa.fleet.FloorView.StandstillView;
import org.toqa.fleet.Hold;
import org.toqa.fleet.PairingOrder;
import org.toqa.fleet.RobotChange;
import org.toqa.fleet.RobotOrder;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.fleet.TaskArchive;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.TaskPreview;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.CellRuns;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Objection;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.mission.Trouble;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** A fleet in memory: it stores wishes by the contract's rules and drives nothing by itself. */
public final class TestFleet implements Fleet, SnapshotFeed, TaskArchive {
  public static final Instant START = Instant.parse("2026-11-21T08:00:00Z");

  /** Kilograms; what all robots together can carry. */
  private static final double HEAVIEST = 50;

  private final FloorMap floor = floor();
  private final List<TaskView> tasks = new ArrayList<>();
  private final Map<UUID, Long> keys = new HashMap<>();
  private final List<EventRecord> events = new ArrayList<>();
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition withChange = lock.newCondition();
  private FleetSnapshot latest =
      new FleetSnapshot(1, START, List.of(), List.of(), 0, List.of(), null, List.of());
  private List<FloorView> floors = List.of();
  private boolean silent;
  private List<Sentence> alerts = List.of();
  private @Nullable Hold pause;

  /** From now on the store does not answer. */
  public void stopAnswering() {
    silent = true;
  }

  /** Publishes what ails the whole fleet. */
  public void setAlert(String alert) {
    lock.lock();
    try {
      alerts = List.of(Sentence.verbatim(alert));
      publish(latest.robots());
    } finally {
      lock.unlock();
    }
  }

  /** Publishes other robots. */
  public void changeRobots(UnaryOperator<List<RobotView>> change) {
    lock.lock();
    try {
      publish(change.apply(latest.robots()));
    } finally {
      lock.unlock();
    }
  }

  /** Publishes what is in the way on the floor. */
  public void changeFloor(FloorView view) {
    lock.lock();
    try {
      floors = List.of(view);
      publish(latest.robots());
    } finally {
      lock.unlock();
    }
  }

  /** Publishes another state of a task and records it. */
  public void changeTask(long id, TaskState state, List<String> robots, String sentence) {
    lock.lock();
    try {
      tasks.replaceAll(
          view ->
              view.id() == id
                  ? new TaskView(
                      view.task(), state, false, robots, null, null, null, null, latest.at())
                  : view);
      events.add(
          new EventRecord(
              latest.at(), state.name(), id, null, "fleet", Sentence.verbatim(sentence)));
      publish(latest.robots());
    } finally {
      lock.unlock();
    }
  }

  /** Publishes that a task will miss its deadline. */
  public void setLate(long id, Sentence sentence) {
    lock.lock();
    try {
      tasks.replaceAll(
          t ->
              t.id() == id
                  ? new TaskView(
                      t.task(),
                      t.state(),
                      t.held(),
                      t.robots(),
                      t.loadAt(),
                      t.waitingFor(),
                      t.needs(),
                      sentence,
                      t.changedAt())
                  : t);
      publish(latest.robots());
    } finally {
      lock.unlock();
    }
  }

  @Override
  public CompletionStage<Answer<TaskView>> submit(TaskOrder order, String user, UUID key) {
    if (silent) {
      return CompletableFuture.failedFuture(new StoreException("no store", null));
    }
    lock.lock();
    try {
      Answer<TransportTask> checked = checked(order, user);
      if (!(checked instanceof Answer.Accepted<TransportTask>(TransportTask task))) {
        return CompletableFuture.completedFuture(checked.asRejection());
      }
      TaskView view =
          new TaskView(
              task,
              TaskState.QUEUED,
              false,
              List.of(),
              null,
              Phrase.LOOKING_FOR_ROBOT.with(),
              null,
              null,
              latest.at());
      tasks.add(view);
      keys.put(key, view.id());
      events.add(
          new EventRecord(
              latest.at(), "QUEUED", task.id(), null, user, Phrase.ASKED_FOR_BY.with(user)));
      publish(latest.robots());
      return CompletableFuture.completedFuture(new Answer.Accepted<>(view));
    } finally {
      lock.unlock();
    }
  }

  @Override
  public CompletionStage<BatchAnswer> submitAll(
      List<TaskOrder> orders, String user, List<UUID> keys) {
    if (silent) {
      return CompletableFuture.failedFuture(new StoreException("no store", null));
    }
    lock.lock();
    try {
      List<BatchAnswer.Rejection> refusals = refusalsOf(orders, user);
      if (!refusals.isEmpty()) {
        return CompletableFuture.completedFuture(new BatchAnswer.Rejected(refusals));
      }
      List<TaskView> added = new ArrayList<>();
      for (int i = 0; i < orders.size(); i++) {
        submit(orders.get(i), user, keys.get(i));
        added.add(tasks.getLast());
      }
      return CompletableFuture.completedFuture(new BatchAnswer.Accepted(added));
    } finally {
      lock.unlock();
    }
  }

  @Override
  public CompletionStage<List<BatchAnswer.Rejection>> rejections(
      List<TaskOrder> orders, String user) {
    lock.lock();
    try {
      return CompletableFuture.completedFuture(refusalsOf(orders, user));
    } finally {
      lock.unlock();
    }
  }

  private List<BatchAnswer.Rejection> refusalsOf(List<TaskOrder> orders, String user) {
    List<BatchAnswer.Rejection> refusals = new ArrayList<>();
    for (int i = 0; i < orders.size(); i++) {
      if (checked(orders.get(i), user)
          instanceof Answer.Rejected<TransportTask>(String field, Sentence sentence)) {
        refusals.add(new BatchAnswer.Rejection(i, field, sentence));
      }
    }
    return refusals;
  }

  private Answer<TransportTask> checked(TaskOrder order, String user) {
    Optional<TaskPlace> start = place(order.start());
    Optional<TaskPlace> goal = place(order.goal());
    if (order.floor() != null && !order.floor().equals(floor.name())) {
      return new Answer.Rejected<>("floor", Phrase.NO_SUCH_FLOOR.with(order.floor()));
    }
    if (order.load() > HEAVIEST) {
      return new Answer.Rejected<>("load", Phrase.TOO_HEAVY_TOGETHER.with(order.load(), HEAVIEST));
    }
    if (start.isEmpty()) {
      return new Answer.Rejected<>(
          "start",
          Sentence.verbatim("The start is not a free place of the floor. Choose another one."));
    }
    if (goal.isEmpty()) {
      return new Answer.Rejected<>(
          "goal",
          Sentence.verbatim("The goal is not a free place of the floor. Choose another one."));
    }
    return new Answer.Accepted<>(
        new TransportTask(
            tasks.size() + 1,
            order.name(),
            order.load(),
            start.get(),
            goal.get(),
            floor.name(),
            order.priority(),
            order.deadline(),
            order.size(),
            user,
            latest.at()));
  }

  /** Two carry it, straight from start to goal. */
  @Override
  public CompletionStage<Answer<TaskPreview>> preview(TaskOrder order, String user) {
    lock.lock();
    try {
      Answer<TransportTask> checked = checked(order, user);
      return CompletableFuture.completedFuture(
          checked instanceof Answer.Accepted<TransportTask>(TransportTask task)
              ? new Answer.Accepted<>(
                  new TaskPreview(
                      2,
                      List.of("r1", "r2"),
                      Phrase.IS_SOONER.with(),
                      List.of(task.start().position(), task.goal().position())))
              : checked.asRejection());
    } finally {
      lock.unlock();
    }
  }

  @Override
  public CompletionStage<Answer<RobotView>> addRobot(RobotOrder order, String user) {
    lock.lock();
    try {
      if (latest.robots().stream().anyMatch(r -> r.name().equals(order.name()))) {
        return refused("name", "There is a robot of that name already. Choose another name.");
      }
      RobotView robot =
          robot(order.name(), RobotState.CONNECTING, null, order.host(), order.port());
      List<RobotView> robots = new ArrayList<>(latest.robots());
      robots.add(robot);
      publish(robots);
      return CompletableFuture.completedFuture(new Answer.Accepted<>(robot));
    } finally {
      lock.unlock();
    }
  }

  @Override
  public CompletionStage<Answer<RobotView>> changeRobot(
      String name, RobotChange change, String user) {
    return change(name, known -> withChange(known, change));
  }

  private static RobotView withChange(RobotView known, RobotChange change) {
    return new RobotView(
        known.name(),
        known.floor(),
        known.state(),
        known.pose(),
        known.battery(),
        known.task(),
        known.phase(),
        change.maxLoad(),
        known.footprint(),
        known.speed(),
        change.host(),
        change.port(),
        change.parking(),
        change.host().equals("127.0.0.1"),
        known.path(),
        known.released(),
        known.errors(),
        known.doing(),
        known.lastSeen(),
        known.held(),
        known.charger(),
        known.fingerprint(),
        known.alert());
  }

  @Override
  public CompletionStage<Answer<RobotView>> removeRobot(String name, String user) {
    lock.lock();
    try {
      Optional<RobotView> known =
          latest.robots().stream().filter(r -> r.name().equals(name)).findFirst();
      if (known.isEmpty()) {
        return CompletableFuture.completedFuture(
            new Answer.Unknown<>(Phrase.NO_SUCH_ROBOT.with(name)));
      }
      if (known.get().state() != RobotState.OUT_OF_SERVICE) {
        return CompletableFuture.completedFuture(
            new Answer.Conflict<>(Phrase.TAKE_OUT_FIRST.with(name), null));
      }
      publish(latest.robots().stream().filter(r -> !r.name().equals(name)).toList());
      return CompletableFuture.completedFuture(new Answer.Accepted<>(known.get()));
    } finally {
      lock.unlock();
    }
  }

  @Override
  public CompletionStage<Answer<RobotView>> pairRobot(
      String name, PairingOrder order, String user) {
    return change(
        name,
        known -> robot(name, RobotState.CONNECTING, known.pose(), order.host(), order.port()));
  }

  @Override
  public CompletionStage<Answer<RobotView>> locateRobot(String name, Pose pose, String user) {
    if (!floor.grid().isFree(pose.position())) {
      return refused(null, "There is a wall. Say where the robot really stands.");
    }
    return change(name, known -> robot(name, RobotState.IDLE, pose, known.host(), known.port()));
  }

  @Override
  public CompletionStage<Answer<RobotView>> takeOutOfService(String name, String user) {
    return change(
        name,
        known -> robot(name, RobotState.OUT_OF_SERVICE, known.pose(), known.host(), known.port()));
  }

  @Override
  public CompletionStage<Answer<RobotView>> putInService(String name, String user) {
    return change(
        name, known -> robot(name, RobotState.IDLE, known.pose(), known.host(), known.port()));
  }

  @Override
  public CompletionStage<Answer<RobotView>> holdRobot(String name, String user) {
    return change(
        name, known -> robot(name, RobotState.HOLDING, known.pose(), known.host(), known.port()));
  }

  @Override
  public CompletionStage<Answer<RobotView>> resumeRobot(String name, String user) {
    return change(
        name, known -> robot(name, RobotState.IDLE, known.pose(), known.host(), known.port()));
  }

  @Override
  public CompletionStage<Answer<RobotView>> sendHome(String name, String user) {
    return change(
        name, known -> robot(name, RobotState.DRIVING, known.pose(), known.host(), known.port()));
  }

  /** Tasks are the mission of one robot, r1. */
  @Override
  public CompletionStage<Answer<TaskView>> commandTask(long id, MissionEvent.OperatorCommand wish) {
    lock.lock();
    try {
      Mission mission = mission(task(id).orElseThrow());
      Optional<Objection> objection = mission.objectionTo(wish);
      if (objection.isPresent()) {
        return CompletableFuture.completedFuture(Answer.conflict(objection.get()));
      }
      TaskView next = TaskView.of(mission.apply(wish).mission(), null, latest.at());
      tasks.replaceAll(view -> view.id() == id ? next : view);
      publish(latest.robots());
      return CompletableFuture.completedFuture(new Answer.Accepted<>(next));
    } finally {
      lock.unlock();
    }
  }

  private static Mission mission(TaskView view) {
    int phase = view.state() == TaskState.CARRYING ? 2 : 1;
    List<AssignedRobot> carriers =
        view.robots().stream().map(robot -> new AssignedRobot(robot, phase, false, false)).toList();
    Trouble trouble =
        view.needs() == null
            ? null
            : new Trouble(
                "r1", Phrase.IS_NOT_HEARD_OF.with(), new TaskPlace(new Vec2(2, 2), null), false);
    return new Mission(view.task(), view.state(), carriers, view.held(), null, null, trouble);
  }

  /** Publishes that a robot of the task, which has the load on board, is lost. */
  public void loseRobotOf(long id) {
    lock.lock();
    try {
      MissionEvent lost = new MissionEvent.RobotLost("r1", new TaskPlace(new Vec2(2, 2), null));
      tasks.replaceAll(
          view ->
              view.id() == id
                  ? TaskView.of(mission(view).apply(lost).mission(), null, latest.at())
                  : view);
      publish(latest.robots());
    } finally {
      lock.unlock();
    }
  }

  @Override
  public CompletionStage<Answer<Optional<Hold>>> pauseAll(String user) {
    return setPause(new Hold(user, START));
  }

  @Override
  public CompletionStage<Answer<Optional<Hold>>> resumeAll(String user) {
    return setPause(null);
  }

  private CompletionStage<Answer<Optional<Hold>>> setPause(@Nullable Hold next) {
    lock.lock();
    try {
      pause = next;
      publish(latest.robots());
      return CompletableFuture.completedFuture(new Answer.Accepted<>(Optional.ofNullable(next)));
    } finally {
      lock.unlock();
    }
  }

  @Override
  public CompletionStage<Answer<Optional<Hold>>> holdFloor(String floor, String user) {
    return setFloorHold(floor, new Hold(user, START));
  }

  @Override
  public CompletionStage<Answer<Optional<Hold>>> resumeFloor(String floor, String user) {
    return setFloorHold(floor, null);
  }

  private CompletionStage<Answer<Optional<Hold>>> setFloorHold(String floor, @Nullable Hold next) {
    lock.lock();
    try {
      if (!floor.equals("hall")) {
        return CompletableFuture.completedFuture(
            new Answer.Unknown<>(Phrase.NO_SUCH_FLOOR.with(floor)));
      }
      floors = List.of(new FloorView(floor, next, CellRuns.NONE, Map.of(), List.of(), List.of()));
      publish(latest.robots());
      return CompletableFuture.completedFuture(new Answer.Accepted<>(Optional.ofNullable(next)));
    } finally {
      lock.unlock();
    }
  }

  private CompletionStage<Answer<RobotView>> change(String name, UnaryOperator<RobotView> change) {
    lock.lock();
    try {
      Optional<RobotView> known =
          latest.robots().stream().filter(r -> r.name().equals(name)).findFirst();
      if (known.isEmpty()) {
        return CompletableFuture.completedFuture(
            new Answer.Unknown<>(Phrase.NO_SUCH_ROBOT.with(name)));
      }
      RobotView next = change.apply(known.get());
      publish(latest.robots().stream().map(r -> r.name().equals(name) ? next : r).toList());
      return CompletableFuture.completedFuture(new Answer.Accepted<>(next));
    } finally {
      lock.unlock();
    }
  }

  @Override
  public List<FloorMap> floors() {
    return List.of(floor);
  }

  @Override
  public SnapshotFeed snapshots() {
    return this;
  }

  @Override
  public FleetSnapshot latest() {
    lock.lock();
    try {
      return latest;
    } finally {
      lock.unlock();
    }
  }

  @Override
  public FleetSnapshot awaitNewer(long version, Duration limit) throws InterruptedException {
    lock.lock();
    try {
      long left = limit.toNanos();
      while (latest.version() <= version && left > 0) {
        left = withChange.awaitNanos(left);
      }
      return latest;
    } finally {
      lock.unlock();
    }
  }

  @Override
  public List<TaskView> tasks(Filter filter, Sort sort, int offset, int limit) {
    lock.lock();
    try {
      Comparator<TaskView> order =
          sort.by() == Sort.Column.LOAD
              ? Comparator.comparingDouble(t -> t.task().load())
              : Comparator.comparingLong(TaskView::id);
      return tasks.stream()
          .filter(task -> isIncluded(task, filter))
          .sorted(sort.descending() ? order.reversed() : order)
          .skip(offset)
          .limit(limit)
          .toList();
    } finally {
      lock.unlock();
    }
  }

  /** By state and text only; the store's tests hold the rest. */
  private static boolean isIncluded(TaskView task, Filter filter) {
    return (filter.states().isEmpty() || filter.states().contains(task.state()))
        && (filter.text() == null || task.task().name().contains(filter.text()));
  }

  @Override
  public Optional<TaskView> taskByKey(UUID key) {
    lock.lock();
    try {
      return Optional.ofNullable(keys.get(key)).flatMap(this::task);
    } finally {
      lock.unlock();
    }
  }

  @Override
  public Optional<TaskView> task(long id) {
    lock.lock();
    try {
      return tasks.stream().filter(t -> t.id() == id).findFirst();
    } finally {
      lock.unlock();
    }
  }

  @Override
  public List<EventRecord> history(long id) {
    lock.lock();
    try {
      return events.stream().filter(e -> e.task() != null && e.task() == id).toList();
    } finally {
      lock.unlock();
    }
  }

  @Override
  public long count(Filter filter) {
    lock.lock();
    try {
      return tasks.stream().filter(task -> isIncluded(task, filter)).count();
    } finally {
      lock.unlock();
    }
  }

  public static RobotView robot(
      String name, RobotState state, @Nullable Pose pose, String host, int port) {
    return new RobotView(
        name,
        "hall",
        state,
        pose,
        pose == null ? null : Double.valueOf(0.84),
        null,
        0,
        5,
        0.255,
        0.25,
        host,
        port,
        "P1",
        host.equals("127.0.0.1"), // else it is a real one
        List.of(),
        0,
        List.of(),
        Phrase.IS_FREE.with(),
        pose == null ? null : START,
        false,
        null,
        null,
        null);
  }

  /** A floor with an obstacle of 2 x 2 cells, those of a lost robot r6, and a standstill. */
  public static FloorView crowdedFloor() {
    return new FloorView(
        "hall",
        null,
        new CellRuns(List.of(375, 2, 415, 2)), // rows 9 and 10, columns 15 and 16
        Map.of("r6", new CellRuns(List.of(490, 2, 530, 2))), // rows 12 and 13, columns 10 and 11
        List.of(
            new StandstillView(
                List.of("r2", "r3"),
                List.of(new Vec2(2.25, 0.75), new Vec2(7.35, 2.85)),
                START,
                Phrase.RING_OF_WAITS.with(
                    Sentence.names(List.of("r2", "r3")),
                    Sentence.joined(
                        Phrase.LISTED,
                        List.of(
                            Sentence.of(new Vec2(2.25, 0.75)),
                            Sentence.of(new Vec2(7.35, 2.85))))))),
        List.of(
            new FaultyCharger(
                "C1",
                new Vec2(10.95, 5.25),
                START,
                Phrase.CHARGER_IS_FAULTY.with("C1", "r2", Phrase.MINUTES.with(10)))));
  }

  private void publish(List<RobotView> robots) {
    latest =
        new FleetSnapshot(
            latest.version() + 1,
            latest.at().plusMillis(200),
            robots,
            newestFirst(),
            (int) tasks.stream().filter(t -> t.state() == TaskState.QUEUED).count(),
            floors,
            pause,
            alerts);
    withChange.signalAll();
  }

  private List<TaskView> newestFirst() {
    List<TaskView> copy = new ArrayList<>(tasks);
    Collections.reverse(copy);
    return copy;
  }

  private Optional<TaskPlace> place(Where where) {
    return switch (where) {
      case Where.Point(Vec2 position) ->
          Optional.of(new TaskPlace(position, null)).filter(p -> floor.grid().isFree(p.position()));
      case Where.Station(String name) ->
          floor.place(name).map(p -> new TaskPlace(p.position(), p.name()));
    };
  }

  private static <T> CompletionStage<Answer<T>> refused(@Nullable String field, String sentence) {
    return CompletableFuture.completedFuture(
        new Answer.Rejected<>(field, Sentence.verbatim(sentence)));
  }

  /** 12 m x 6 m in cells of 0.3 m, walls around and one wall with a passage. */
  private static FloorMap floor() {
    int width = 40;
    int height = 20;
    BitSet occupied = new BitSet();
    for (int row = 0; row < height; row++) {
      for (int column = 0; column < width; column++) {
        boolean edge = row == 0 || row == height - 1 || column == 0 || column == width - 1;
        boolean wall = column == 20 && (row < 8 || row > 11);
        boolean shelf = row == 6 && column > 5 && column < 15;
        occupied.set(row * width + column, edge || wall || shelf);
      }
    }
    return new FloorMap(
        "hall",
        new OccupancyGrid(width, height, 0.3, Vec2.ZERO, occupied),
        List.of(place("Dock A", 1.05, 5.25), place("Shelf 3", 10.35, 1.05)),
        List.of(place("P1", 1.05, 0.75), place("P2", 2.25, 0.75), place("P3", 3.45, 0.75)),
        List.of(place("C1", 10.95, 5.25)));
  }

  private static Place place(String name, double x, double y) {
    return new Place(name, new Vec2(x, y));
  }
}
