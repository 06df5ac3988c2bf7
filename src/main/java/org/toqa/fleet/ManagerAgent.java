package org.toqa.fleet;

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
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.allocation.Allocator;
import org.toqa.allocation.Candidate;
import org.toqa.allocation.Decision;
import org.toqa.fleet.FleetStore.OpenTask;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.link.RobotLinks;
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

  /** A queued task and what it waits for. */
  private record Waiting(TransportTask task, String why, Instant since) {
    TaskView view() {
      return new TaskView(task, TaskState.QUEUED, false, List.of(), why, null, since);
    }
  }

  static Behavior<ManagerMessage> of(
      List<FloorMap> floors,
      FleetStore store,
      RobotLinks links,
      Allocator allocator,
      InstantSource clock,
      Instant now,
      SnapshotBoard board) {
    List<RobotRecord> robots = store.robots();
    Set<String> outOfService = store.outOfService();
    List<OpenTask> open = store.openTasks();
    return AgentFleet.goingOn(
        Behaviors.setup(
            context ->
                new ManagerAgent(
                    context,
                    floors,
                    robots,
                    outOfService,
                    open,
                    store,
                    links,
                    allocator,
                    clock,
                    now,
                    board)));
  }

  private ManagerAgent(
      ActorContext<ManagerMessage> context,
      List<FloorMap> floorMaps,
      List<RobotRecord> stored,
      Set<String> outOfService,
      List<OpenTask> open,
      FleetStore store,
      RobotLinks links,
      Allocator allocator,
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
    stored.forEach(r -> robots.put(r.name(), r));
    for (OpenTask t : open) {
      if (t.state() == TaskState.QUEUED) {
        queue.put(t.task().id(), new Waiting(t.task(), "Looking for a robot.", t.changedAt()));
      }
    }
    for (FloorMap floor : floorMaps) {
      List<RobotRecord> here = stored.stream().filter(r -> r.floor().equals(floor.name())).toList();
      List<OpenTask> begun =
          open.stream()
              .filter(t -> t.state() != TaskState.QUEUED && t.task().floor().equals(floor.name()))
              .toList();
      ActorRef<FloorMessage> agent =
          context.spawn(
              FloorAgent.of(
                  floor, here, outOfService, begun, store, links, clock, now, context.getSelf()),
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
      case ManagerMessage.Begun m -> handedOver.remove(m.task());
      case ManagerMessage.NotBegun m -> requeue(m.task());
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
    Waiting waiting = new Waiting(m.task(), "Looking for a robot.", m.task().createdAt());
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
      switch (allocator.allocate(task.load(), task.start().position(), here)) {
        case Decision.Assigned(List<String> chosen, String why) -> {
          handOver(task, chosen, why);
          candidates.put(task.floor(), candidates(task.floor()));
        }
        case Decision.Waits(String why) -> {
          if (!why.equals(w.why())) {
            queue.put(task.id(), new Waiting(task, why, w.since()));
            changed = true;
          }
        }
      }
    }
  }

  private void handOver(TransportTask task, List<String> chosen, String why) {
    Optional<ActorRef<FloorMessage>> floor = floorAgent(task.floor());
    if (floor.isEmpty()) {
      return;
    }
    queue.remove(task.id());
    handedOver.put(
        task.id(),
        new TaskView(task, TaskState.ASSIGNED, false, chosen, null, null, clock.instant()));
    floor.get().tell(new FloorMessage.Begin(task, chosen, why));
    changed = true;
  }

  private void requeue(TransportTask task) {
    handedOver.remove(task.id());
    queue.put(task.id(), new Waiting(task, "Looking for a robot.", clock.instant()));
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
