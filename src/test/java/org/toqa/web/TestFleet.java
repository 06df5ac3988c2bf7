package org.toqa.web;

import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.FloorEditing;
import org.toqa.fleet.FloorView.BoxView;
import org.toqa.fleet.Hold;
import org.toqa.fleet.ManualAnswer;
import org.toqa.fleet.ManualOrder;
import org.toqa.fleet.PairingOrder;
import org.toqa.fleet.RobotChange;
import org.toqa.fleet.RobotMove;
import org.toqa.fleet.RobotOrder;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.RobotView.Work;
import org.toqa.fleet.ScheduleStore;
import org.toqa.fleet.Schedules;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.fleet.schedule.StoredSchedules;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.testbed.Hall;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** A fleet in memory: it does what it is told at once, and drives nothing by itself. */
public final class TestFleet extends TasksInMemory {
  private final List<ManualOrder> manualOrders = new CopyOnWriteArrayList<>();

  private final Schedules schedules;
  private final FloorsInMemory drawn = new FloorsInMemory(this);

  /**
   * @param accountId the id of the user who has a name
   */
  TestFleet(ScheduleStore scheduleStore, Function<String, @Nullable Long> accountId) {
    super(accountId);
    this.schedules = new StoredSchedules(scheduleStore, this, InstantSource.system());
  }

  @Override
  public FloorEditing floorEditing() {
    return drawn;
  }

  @Override
  public Schedules schedules() {
    return schedules;
  }

  @Override
  public CompletionStage<Answer<RobotView>> addRobot(RobotOrder order, String user) {
    lock.lock();
    try {
      if (latest.robots().stream().anyMatch(r -> r.name().equals(order.name()))) {
        return refused("name", "There is already a robot of that name. Choose another name.");
      }
      RobotView robot =
          Hall.robot(order.name(), RobotState.CONNECTING, null, order.host(), order.port());
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
      String name, RobotChange change, @Nullable RobotChange seen, String user) {
    RobotRecord changed = Hall.record(name, change.host(), change.port()).withChange(change);
    return change(name, known -> known.withRecord(changed));
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
        known ->
            Hall.robot(
                name, RobotState.CONNECTING, known.telemetry().pose(), order.host(), order.port()));
  }

  @Override
  public CompletionStage<Answer<RobotView>> locateRobot(String name, Pose pose, String user) {
    if (!floor.grid().isFree(pose.position())) {
      return refused(null, "There is a wall. Say where the robot really stands.");
    }
    return change(name, known -> standing(known, RobotState.IDLE, pose));
  }

  @Override
  public CompletionStage<Answer<RobotView>> takeOutOfService(String name, String user) {
    return change(
        name, known -> standing(known, RobotState.OUT_OF_SERVICE, known.telemetry().pose()));
  }

  @Override
  public CompletionStage<Answer<RobotView>> putInService(String name, String user) {
    return change(name, known -> standing(known, RobotState.IDLE, known.telemetry().pose()));
  }

  @Override
  public CompletionStage<Answer<RobotView>> holdRobot(String name, String user) {
    return change(
        name,
        known -> {
          RobotView still = standing(known, RobotState.HOLDING, known.telemetry().pose());
          Work work = still.work();
          return still.withWork(
              new Work(work.task(), work.phase(), true, work.charger(), work.doing()));
        });
  }

  @Override
  public CompletionStage<Answer<ManualAnswer>> driveByHand(
      String name, ManualOrder order, String user) {
    UUID lease = order.lease() == null ? UUID.randomUUID() : order.lease();
    manualOrders.add(order);
    return change(name, known -> driven(known, user))
        .thenApply(
            answer ->
                answer instanceof Answer.Accepted<RobotView>
                    ? new Answer.Accepted<>(new ManualAnswer(lease, user, !order.isStop(), null))
                    : answer.asRejection());
  }

  @Override
  public CompletionStage<Answer<RobotView>> endManualDrive(String name, UUID lease, String user) {
    return change(name, known -> driven(known, null));
  }

  /** Of whoever drove robots by hand, in their order. */
  public List<ManualOrder> manualOrders() {
    return List.copyOf(manualOrders);
  }

  private static RobotView driven(RobotView robot, @Nullable String driver) {
    Work work = robot.work();
    return robot.withWork(
        new Work(work.task(), work.phase(), work.held(), work.charger(), work.doing(), driver));
  }

  @Override
  public CompletionStage<Answer<RobotView>> resumeRobot(String name, String user) {
    return change(name, known -> standing(known, RobotState.IDLE, known.telemetry().pose()));
  }

  @Override
  public CompletionStage<Answer<RobotView>> clearStops(
      String name, Set<String> reasons, String user) {
    Set<String> stops =
        latest.robots().stream()
            .filter(r -> r.name().equals(name))
            .flatMap(r -> r.stops().stream())
            .map(Fault::code)
            .collect(Collectors.toSet());
    return stops.equals(reasons)
        ? change(name, known -> standing(known, RobotState.IDLE, known.telemetry().pose()))
        : CompletableFuture.completedFuture(
            new Answer.Conflict<>(Phrase.STOPS_HAVE_CHANGED.with(name, stops.toString()), null));
  }

  /** Tests put boxes on snapshots themselves. */
  @Override
  public void showBoxes(String floor, List<BoxView> boxes) {}

  @Override
  public CompletionStage<Answer<RobotView>> sendTo(String name, Vec2 place) {
    return sendHome(name, "");
  }

  @Override
  public CompletionStage<Answer<RobotView>> sendHome(String name, String user) {
    return change(name, known -> standing(known, RobotState.DRIVING, known.telemetry().pose()));
  }

  @Override
  public CompletionStage<Answer<Optional<Hold>>> pauseAll(String user) {
    return setPause(new Hold(user, Hall.START));
  }

  @Override
  public CompletionStage<Answer<Optional<Hold>>> resumeAll(String user) {
    return setPause(null);
  }

  @Override
  public CompletionStage<Answer<Optional<Hold>>> holdFloor(String floor, String user) {
    return setFloorHold(floor, new Hold(user, Hall.START));
  }

  @Override
  public CompletionStage<Answer<Optional<Hold>>> resumeFloor(String floor, String user) {
    return setFloorHold(floor, null);
  }

  @Override
  public CompletionStage<Answer<Optional<String>>> chooseAllocator(
      String floor, Optional<String> allocator, String user) {
    return CompletableFuture.completedFuture(chooseAllocator(floor, allocator));
  }

  private static RobotView standing(RobotView known, RobotState state, @Nullable Pose pose) {
    return Hall.robot(known.name(), state, pose, known.record().host(), known.record().port());
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
    return drawn.floors();
  }

  @Override
  void forgetAll() {
    super.forgetAll();
    drawn.forget();
  }

  @Override
  public CompletionStage<Answer<RobotView>> moveRobot(String robot, RobotMove move, String user) {
    return refused("floor", "There is no other floor.");
  }

  @Override
  public SnapshotFeed snapshots() {
    return this;
  }

  @Override
  public Optional<SnapshotFeed> snapshots(String name) {
    return name.equals(floor.name()) ? Optional.of(this) : Optional.empty();
  }

  private static <T> CompletionStage<Answer<T>> refused(@Nullable String field, String sentence) {
    return CompletableFuture.completedFuture(
        new Answer.Rejected<>(field, Sentence.verbatim(sentence)));
  }
}
