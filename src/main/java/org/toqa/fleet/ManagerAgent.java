package org.toqa.fleet;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.actor.typed.Behavior;
import org.apache.pekko.actor.typed.PostStop;
import org.apache.pekko.actor.typed.javadsl.AbstractBehavior;
import org.apache.pekko.actor.typed.javadsl.ActorContext;
import org.apache.pekko.actor.typed.javadsl.Behaviors;
import org.apache.pekko.actor.typed.javadsl.Receive;
import org.apache.pekko.pattern.StatusReply;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.allocation.Allocator;
import org.toqa.allocation.Candidate;
import org.toqa.allocation.Decision;
import org.toqa.fleet.FleetStore.OpenTask;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.link.RobotLinks;
import org.toqa.mission.Mission;
import org.toqa.mission.Objection;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;

/**
 * Takes tasks, keeps their queue, decides who carries what, and hangs up the picture of the whole
 * fleet. An accepted task is stored before its asker is answered; robots are given it by its floor.
 */
final class ManagerAgent extends AbstractBehavior<ManagerMessage> {
  private static final Logger log = LoggerFactory.getLogger(ManagerAgent.class);
  private static final int ENDED_SHOWN = 50;

  private final FleetStore store;
  private final StoreWriter writer;
  private final InstantSource clock;
  private final Allocator allocator;
  private final OrderCheck check;
  private final SnapshotBoard board;
  private final Map<String, ActorRef<FloorMessage>> floors = new LinkedHashMap<>();

  private final Map<Long, Waiting> queue = new LinkedHashMap<>();
  private final Map<String, RobotRecord> robots = new TreeMap<>();
  private final Map<String, ManagerMessage.FloorReport> reports = new HashMap<>();
  private final Map<Long, TaskView> handedOver = new HashMap<>();
  private final Deque<TaskView> ended = new ArrayDeque<>();

  /** By floor: the robots that can be given a task. */
  private final Map<String, Set<String>> available = new HashMap<>();

  /** Whether robots or tasks have changed since the queue was last gone through. */
  private boolean reconsider = true;

  private boolean changed = true;

  private @Nullable FleetPause pause;

  /**
   * A queued task and what it waits for.
   *
   * @param stored whether it is in the store as it is here
   */
  private record Waiting(Mission mission, String why, Instant since, boolean stored) {
    static Waiting of(Mission mission, Instant since) {
      return new Waiting(mission, "Looking for a robot.", since, true);
    }

    TransportTask task() {
      return mission.task();
    }

    boolean mayBegin() {
      return stored && !mission.held();
    }

    Waiting because(String reason) {
      return new Waiting(mission, reason, since, stored);
    }

    TaskView view() {
      return TaskView.of(mission, mission.held() ? "On hold." : why, since);
    }
  }

  static Behavior<ManagerMessage> of(
      List<FloorMap> floors,
      FleetStore store,
      RobotLinks links,
      Allocator allocator,
      Duration lostAfter,
      InstantSource clock,
      Instant now,
      SnapshotBoard board) {
    return AgentFleet.goingOn(
        Behaviors.setup(
            context ->
                new ManagerAgent(
                    context, floors, store, links, allocator, lostAfter, clock, now, board)));
  }

  private ManagerAgent(
      ActorContext<ManagerMessage> context,
      List<FloorMap> floorMaps,
      FleetStore store,
      RobotLinks links,
      Allocator allocator,
      Duration lostAfter,
      InstantSource clock,
      Instant now,
      SnapshotBoard board) {
    super(context);
    this.store = store;
    this.clock = clock;
    this.allocator = allocator;
    this.board = board;
    this.check = new OrderCheck(floorMaps);
    this.writer = new StoreWriter("manager");
    List<RobotRecord> stored = store.robots();
    List<OpenTask> open = store.openTasks();
    Set<String> outOfService = store.outOfService();
    Set<String> held = store.held();
    this.pause = store.pause().orElse(null);
    stored.forEach(r -> robots.put(r.name(), r));
    for (OpenTask t : open) {
      if (t.mission().state() == TaskState.QUEUED) {
        queue.put(t.mission().id(), Waiting.of(t.mission(), t.changedAt()));
      }
    }
    for (FloorMap floor : floorMaps) {
      FloorMemory memory =
          new FloorMemory(
              stored.stream().filter(r -> r.floor().equals(floor.name())).toList(),
              outOfService,
              held,
              pause,
              open.stream()
                  .filter(t -> t.mission().state() != TaskState.QUEUED)
                  .filter(t -> t.mission().task().floor().equals(floor.name()))
                  .toList());
      ActorRef<FloorMessage> agent =
          context.spawn(
              FloorAgent.of(floor, memory, store, links, lostAfter, clock, now, context.getSelf()),
              "floor-" + floors.size());
      floors.put(floor.name(), agent);
    }
    log.info(
        "{} robots, {} tasks not ended, {} of them queued.",
        robots.size(),
        open.size(),
        queue.size());
  }

  @Override
  public Receive<ManagerMessage> createReceive() {
    return newReceiveBuilder()
        .onAnyMessage(this::on)
        .onSignal(PostStop.class, signal -> closed())
        .build();
  }

  private Behavior<ManagerMessage> on(ManagerMessage message) {
    switch (message) {
      case ManagerMessage.Submit m -> submit(m);
      case ManagerMessage.TaskStored m -> taskStored(m);
      case ManagerMessage.AddRobot m -> addRobot(m);
      case ManagerMessage.RobotStored m -> robotStored(m);
      case ManagerMessage.RobotNotStored m -> robots.remove(m.robot());
      case ManagerMessage.Locate m -> locate(m);
      case ManagerMessage.Serve m -> serve(m);
      case ManagerMessage.HoldRobot m ->
          tellFloorOf(
              m.robot(),
              m.replyTo(),
              new FloorMessage.HoldRobot(m.robot(), m.hold(), m.user(), m.replyTo()));
      case ManagerMessage.SendHome m ->
          tellFloorOf(
              m.robot(), m.replyTo(), new FloorMessage.SendHome(m.robot(), m.user(), m.replyTo()));
      case ManagerMessage.Wished m -> wished(m);
      case ManagerMessage.WishStored m -> wishStored(m.mission());
      case ManagerMessage.Pause m -> pause(m);
      case ManagerMessage.PauseEnded m -> pauseEnded();
      case ManagerMessage.Returned m -> requeue(m.mission());
      case ManagerMessage.Begun m -> handedOver.remove(m.task());
      case ManagerMessage.NotBegun m -> requeue(m.mission());
      case ManagerMessage.FloorReport m -> reported(m);
      case ManagerMessage.Tick m -> tick(m.now());
    }
    return this;
  }

  // --- wishes -----------------------------------------------------------------------------------

  private void submit(ManagerMessage.Submit m) {
    double strongest =
        robots.values().stream().mapToDouble(RobotRecord::maxLoad).max().orElse(Double.MAX_VALUE);
    Answer<TransportTask> checked = check.task(m.order(), m.user(), clock.instant(), strongest);
    if (checked instanceof Answer.Accepted<TransportTask>(TransportTask task)) {
      store(task, m.replyTo());
    } else {
      m.replyTo().tell(StatusReply.success(checked.refusal()));
    }
  }

  private void store(TransportTask task, ActorRef<StatusReply<Answer<TaskView>>> replyTo) {
    ActorRef<ManagerMessage> self = getContext().getSelf();
    writer.tryOnce(
        () -> self.tell(new ManagerMessage.TaskStored(store.addTask(task), replyTo)),
        () -> {},
        failure ->
            replyTo.tell(
                StatusReply.error(
                    "The database does not answer, so the task was not accepted; try again.")));
  }

  private void taskStored(ManagerMessage.TaskStored m) {
    Waiting waiting = Waiting.of(Mission.queued(m.task()), m.task().createdAt());
    queue.put(m.task().id(), waiting);
    m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(waiting.view())));
    changed = true;
    reconsider = true;
  }

  private void addRobot(ManagerMessage.AddRobot m) {
    Answer<RobotRecord> checked = check.robot(m.order(), List.copyOf(robots.values()));
    if (checked instanceof Answer.Accepted<RobotRecord>(RobotRecord robot)) {
      store(robot, m);
    } else {
      m.replyTo().tell(StatusReply.success(checked.refusal()));
    }
  }

  private void store(RobotRecord robot, ManagerMessage.AddRobot m) {
    robots.put(robot.name(), robot); // the name and its parking point are taken from now on
    ActorRef<ManagerMessage> self = getContext().getSelf();
    EventRecord event =
        new EventRecord(
            clock.instant(),
            "robot.added",
            null,
            robot.name(),
            m.user(),
            m.user() + " added " + robot.name());
    writer.tryOnce(
        () -> {
          store.saveRobot(robot);
          store.addEvents(List.of(event));
        },
        () -> self.tell(new ManagerMessage.RobotStored(robot, m.replyTo())),
        failure -> {
          self.tell(new ManagerMessage.RobotNotStored(robot.name()));
          m.replyTo()
              .tell(
                  StatusReply.error(
                      "The database does not answer, so the robot was not added; try again."));
        });
  }

  private void robotStored(ManagerMessage.RobotStored m) {
    floorAgent(m.robot().floor()).ifPresent(f -> f.tell(new FloorMessage.RobotJoined(m.robot())));
    m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(RobotView.unheard(m.robot()))));
  }

  private void locate(ManagerMessage.Locate m) {
    tellFloorOf(
        m.robot(),
        m.replyTo(),
        new FloorMessage.Locate(m.robot(), m.pose(), m.user(), m.replyTo()));
  }

  private void serve(ManagerMessage.Serve m) {
    tellFloorOf(
        m.robot(),
        m.replyTo(),
        new FloorMessage.Serve(m.robot(), m.inService(), m.user(), m.replyTo()));
  }

  /** A task that has robots is its floor's; the floor hands back what it does not have. */
  private void wished(ManagerMessage.Wished m) {
    Waiting waiting = queue.get(m.task());
    if (waiting != null) {
      wished(waiting, m);
      return;
    }
    floorOf(m.task())
        .ifPresentOrElse(
            floor -> floor.tell(new FloorMessage.Wished(m.task(), m.wish(), m.replyTo())),
            () ->
                m.replyTo()
                    .tell(
                        StatusReply.success(
                            new Answer.Conflict<>(
                                "Task " + m.task() + " has ended; it cannot be changed any more.",
                                null))));
  }

  private void wished(Waiting waiting, ManagerMessage.Wished m) {
    Optional<Objection> objection = waiting.mission().objectionTo(m.wish());
    if (objection.isPresent()) {
      m.replyTo().tell(StatusReply.success(Answer.conflict(objection.get())));
      return;
    }
    Mission.Step step = waiting.mission().on(m.wish());
    Instant at = clock.instant();
    Mission mission = step.mission();
    Waiting next = new Waiting(mission, waiting.why(), waiting.since(), !step.changed());
    if (mission.state().isEnded()) {
      queue.remove(m.task());
      shelve(TaskView.of(mission, null, at));
    } else {
      queue.put(m.task(), next);
    }
    changed = true;
    ActorRef<ManagerMessage> self = getContext().getSelf();
    if (step.changed()) {
      writer.write(
          () -> store.saveMission(mission, at, EventRecord.of(step, m.wish(), at)),
          () -> self.tell(new ManagerMessage.WishStored(mission)));
    }
    writer.write(
        () -> {}, () -> m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(next.view()))));
  }

  private void wishStored(Mission mission) {
    queue.computeIfPresent(
        mission.id(),
        (id, waiting) ->
            waiting.mission().equals(mission)
                ? new Waiting(mission, waiting.why(), waiting.since(), true)
                : waiting);
    reconsider = true;
  }

  private Optional<ActorRef<FloorMessage>> floorOf(long task) {
    return Stream.concat(
            handedOver.values().stream(),
            reports.values().stream().flatMap(r -> r.missions().stream()))
        .filter(t -> t.id() == task)
        .findFirst()
        .flatMap(t -> floorAgent(t.task().floor()));
  }

  /** Robots hold at once, and go on only when that is stored. */
  private void pause(ManagerMessage.Pause m) {
    Instant at = clock.instant();
    if (m.pause() == (pause != null)) {
      m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(Optional.ofNullable(pause))));
      return;
    }
    FleetPause next = m.pause() ? new FleetPause(m.user(), at) : null;
    EventRecord event =
        new EventRecord(
            at,
            m.pause() ? "fleet.paused" : "fleet.resumed",
            null,
            null,
            m.user(),
            m.user() + (m.pause() ? " paused all robots" : " let all robots go on"));
    if (next != null) {
      pauseIs(next);
    }
    ActorRef<ManagerMessage> self = getContext().getSelf();
    writer.write(
        () -> store.savePause(next, List.of(event)),
        () -> {
          if (next == null) {
            self.tell(new ManagerMessage.PauseEnded());
          }
          m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(Optional.ofNullable(next))));
        });
  }

  private void pauseEnded() {
    pauseIs(null);
  }

  private void pauseIs(@Nullable FleetPause next) {
    pause = next;
    changed = true;
    floors.values().forEach(f -> f.tell(new FloorMessage.Pause(next)));
  }

  private void tellFloorOf(
      String robot, ActorRef<StatusReply<Answer<RobotView>>> replyTo, FloorMessage message) {
    Optional.ofNullable(robots.get(robot))
        .map(RobotRecord::floor)
        .flatMap(this::floorAgent)
        .ifPresentOrElse(
            floor -> floor.tell(message),
            () ->
                replyTo.tell(
                    StatusReply.success(new Answer.Unknown<>("There is no robot " + robot + "."))));
  }

  private Optional<ActorRef<FloorMessage>> floorAgent(String name) {
    return Optional.ofNullable(floors.get(name));
  }

  // --- allocation -------------------------------------------------------------------------------

  private void reported(ManagerMessage.FloorReport m) {
    reports.put(m.floor().name(), m);
    m.ended().forEach(this::shelve);
    changed = true;
    Set<String> free =
        m.robots().stream()
            .filter(this::isAvailable)
            .map(RobotView::name)
            .collect(Collectors.toSet());
    if (!free.equals(available.put(m.floor().name(), free))) {
      reconsider = true;
    }
  }

  private void shelve(TaskView task) {
    ended.addFirst(task);
    if (ended.size() > ENDED_SHOWN) {
      ended.removeLast();
    }
  }

  /** Goes through the queue, highest priority first, and gives each task robots if there are. */
  private void allocate() {
    reconsider = false;
    Map<String, List<Candidate>> candidates = new HashMap<>();
    floors.keySet().forEach(floor -> candidates.put(floor, candidates(floor)));
    List<Waiting> inOrder =
        queue.values().stream()
            .filter(Waiting::mayBegin)
            .sorted(
                Comparator.comparingInt((Waiting w) -> -w.task().priority())
                    .thenComparing(w -> w.task().id()))
            .toList();
    for (Waiting w : inOrder) {
      TransportTask task = w.task();
      if (!reports.containsKey(task.floor())) {
        continue;
      }
      List<Candidate> here = candidates.getOrDefault(task.floor(), List.of());
      switch (allocator.allocate(task.load(), w.mission().object().position(), here)) {
        case Decision.Assigned(List<String> chosen, String why) -> {
          handOver(w.mission(), chosen, why);
          candidates.put(task.floor(), candidates(task.floor()));
        }
        case Decision.Waits(String why) -> {
          if (!why.equals(w.why())) {
            queue.put(task.id(), w.because(why));
            changed = true;
          }
        }
      }
    }
  }

  private void handOver(Mission mission, List<String> chosen, String why) {
    TransportTask task = mission.task();
    Optional<ActorRef<FloorMessage>> floor = floorAgent(task.floor());
    if (floor.isEmpty()) {
      return;
    }
    queue.remove(task.id());
    handedOver.put(
        task.id(), TaskView.of(mission.assign(chosen, why).mission(), null, clock.instant()));
    floor.get().tell(new FloorMessage.Begin(mission, chosen, why));
    changed = true;
  }

  private void requeue(Mission mission) {
    handedOver.remove(mission.id());
    queue.put(mission.id(), Waiting.of(mission, clock.instant()));
    changed = true;
    reconsider = true;
  }

  private List<Candidate> candidates(String floor) {
    ManagerMessage.FloorReport report = reports.get(floor);
    if (report == null) {
      return List.of();
    }
    List<Candidate> candidates = new ArrayList<>();
    for (RobotView r : report.robots()) {
      Vec2 position = r.pose() == null ? Vec2.ZERO : r.pose().position();
      candidates.add(new Candidate(r.name(), r.maxLoad(), position, isAvailable(r)));
    }
    return candidates;
  }

  private boolean isAvailable(RobotView r) {
    boolean awaited = handedOver.values().stream().anyMatch(t -> t.robots().contains(r.name()));
    boolean fit = r.state() == RobotState.IDLE || r.state() == RobotState.DRIVING;
    return !awaited && fit && (r.task() == null || r.phase() == 3);
  }

  // --- the picture ------------------------------------------------------------------------------

  private void tick(Instant now) {
    floors.values().forEach(f -> f.tell(new FloorMessage.Tick(now)));
    if (reconsider) {
      allocate();
    }
    if (changed) {
      publish();
    }
  }

  private void publish() {
    changed = false;
    List<RobotView> views = new ArrayList<>();
    Map<Long, TaskView> tasks = new HashMap<>();
    List<String> alerts = new ArrayList<>();
    ended.forEach(t -> tasks.put(t.id(), t));
    queue.values().forEach(w -> tasks.put(w.task().id(), w.view()));
    for (ManagerMessage.FloorReport report : reports.values()) {
      views.addAll(report.robots());
      report.missions().forEach(t -> tasks.put(t.id(), t));
      alerts.addAll(report.alerts());
    }
    handedOver.values().forEach(t -> tasks.putIfAbsent(t.id(), t));
    views.sort(Comparator.comparing(RobotView::name));
    List<TaskView> newestFirst =
        tasks.values().stream().sorted(Comparator.comparingLong(TaskView::id).reversed()).toList();
    board.publish(
        new FleetSnapshot(
            board.latest().version() + 1,
            clock.instant(),
            views,
            newestFirst,
            floorViews(),
            pause,
            alerts));
  }

  private List<FloorView> floorViews() {
    return floors.keySet().stream()
        .flatMap(floor -> Stream.ofNullable(reports.get(floor)))
        .map(ManagerMessage.FloorReport::floor)
        .toList();
  }

  private Behavior<ManagerMessage> closed() {
    writer.close();
    return this;
  }
}
