package org.toqa.fleet;

import static java.util.Objects.requireNonNull;

import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
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
import org.toqa.allocation.Job;
import org.toqa.allocation.Situation;
import org.toqa.allocation.Standing;
import org.toqa.allocation.Travel;
import org.toqa.allocation.WaitingReason;
import org.toqa.fleet.FleetStore.OpenTask;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;
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
  private static final int QUEUED_SHOWN = 100;

  /** So many of the queue's first tasks take part in a round. */
  private static final int LOOKED_AT = 200;

  private static final String NOT_LOOKED_AT = "Looking for a robot.";

  private final FleetStore store;
  private final StoreWriter writer;
  private final InstantSource clock;
  private final Allocator allocator;
  private final OrderCheck check;
  private final SnapshotBoard board;
  private final Map<String, ActorRef<FloorMessage>> floors = new LinkedHashMap<>();
  private final Map<String, FloorMap> maps = new HashMap<>();
  private final Map<String, FloorDistances> distances = new HashMap<>();

  private final TaskQueue queue = new TaskQueue();
  private final Map<String, RobotRecord> robots = new TreeMap<>();
  private final Map<String, ManagerMessage.FloorReport> reports = new HashMap<>();
  private final Map<Long, TaskView> handedOver = new HashMap<>();
  private final Deque<TaskView> ended = new ArrayDeque<>();

  /** By floor: what its robots were last seen to be kept by. */
  private final Map<String, Map<String, Standing>> standings = new HashMap<>();

  /** By floor and task: what the last round said of those that wait. */
  private final Map<String, Map<Long, String>> reasons = new HashMap<>();

  /** Floors whose robots or tasks have changed since the last round began. */
  private final Set<String> due = new HashSet<>();

  /** Floors with a round under way. */
  private final Set<String> deciding = new HashSet<>();

  private boolean changed = true;

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
        queue.add(t.task(), t.changedAt());
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
      maps.put(floor.name(), floor);
      distances.put(
          floor.name(), new FloorDistances(Inflation.of(floor.grid(), OrderCheck.SMALLEST_RADIUS)));
      due.add(floor.name());
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
      case ManagerMessage.Decided m -> decided(m);
      case ManagerMessage.Tick m -> tick(m.now());
    }
    return this;
  }

  // --- wishes -----------------------------------------------------------------------------------

  private void submit(ManagerMessage.Submit m) {
    double together =
        robots.isEmpty()
            ? Double.MAX_VALUE
            : robots.values().stream().mapToDouble(RobotRecord::maxLoad).sum();
    Answer<TransportTask> checked = check.task(m.order(), m.user(), clock.instant(), together);
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
    TransportTask task = m.task();
    queue.add(task, task.createdAt());
    m.replyTo()
        .tell(
            StatusReply.success(
                new Answer.Accepted<>(waiting(task, NOT_LOOKED_AT, task.createdAt()))));
    changed = true;
    due.add(task.floor());
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
    Map<String, Standing> now =
        candidates(m.floor().name()).stream()
            .collect(Collectors.toMap(Candidate::robot, Candidate::standing));
    if (!now.equals(standings.put(m.floor().name(), now))) {
      due.add(m.floor().name());
    }
  }

  private void shelve(TaskView task) {
    ended.addFirst(task);
    if (ended.size() > ENDED_SHOWN) {
      ended.removeLast();
    }
  }

  /** Lets the allocator decide, on a thread of its own, on each floor where it is time. */
  private void beginRounds() {
    for (String floor : List.copyOf(due)) {
      if (reports.containsKey(floor) && !deciding.contains(floor)) {
        due.remove(floor);
        beginRound(requireNonNull(maps.get(floor)));
      }
    }
  }

  private void beginRound(FloorMap floor) {
    List<Candidate> robotsHere = candidates(floor.name());
    double strongest =
        robotsHere.stream()
            .filter(r -> r.standing() == Standing.FREE)
            .mapToDouble(Candidate::maxLoad)
            .max()
            .orElse(Double.NEGATIVE_INFINITY);
    List<Job> jobs = queue.first(floor.name(), job -> job.load() <= strongest, LOOKED_AT);
    if (jobs.isEmpty()) {
      reasons.remove(floor.name());
      changed = true;
      return;
    }
    deciding.add(floor.name());
    Situation situation = situation(floor, jobs, robotsHere);
    getContext()
        .pipeToSelf(
            CompletableFuture.supplyAsync(
                () -> allocator.allocate(situation),
                round -> Thread.ofVirtual().name("allocation-" + floor.name()).start(round)),
            (decisions, failure) -> decided(floor.name(), decisions, failure));
  }

  private Situation situation(FloorMap floor, List<Job> jobs, List<Candidate> robotsHere) {
    OccupancyGrid grid = floor.grid();
    Vec2 size = new Vec2(grid.width(), grid.height()).times(grid.resolution());
    return new Situation(
        clock.instant(),
        grid.origin(),
        grid.origin().plus(size),
        requireNonNull(distances.get(floor.name())),
        jobs,
        List.of(),
        robotsHere);
  }

  private static ManagerMessage decided(
      String floor, @Nullable List<Decision> decisions, @Nullable Throwable failure) {
    if (failure != null) {
      log.error("{}: a round of allocation failed.", floor, failure);
    }
    return new ManagerMessage.Decided(floor, decisions == null ? List.of() : decisions);
  }

  /** Gives the tasks to robots that are still free; the rest is for the next round. */
  private void decided(ManagerMessage.Decided m) {
    deciding.remove(m.floor());
    changed = true;
    Set<String> free =
        candidates(m.floor()).stream()
            .filter(r -> r.standing() == Standing.FREE)
            .map(Candidate::robot)
            .collect(Collectors.toSet());
    Map<Long, String> waiting = new HashMap<>();
    for (Decision decision : m.decisions()) {
      switch (decision) {
        case Decision.Assigned(long id, List<String> chosen, String why) -> {
          if (free.containsAll(chosen)) {
            queue.remove(id).ifPresent(task -> handOver(task, chosen, why));
          } else {
            due.add(m.floor());
          }
        }
        case Decision.Waits(long id, String why) -> waiting.put(id, why);
      }
    }
    reasons.put(m.floor(), waiting);
  }

  private void handOver(TransportTask task, List<String> chosen, String why) {
    handedOver.put(
        task.id(),
        new TaskView(task, TaskState.ASSIGNED, false, chosen, null, null, clock.instant()));
    requireNonNull(floors.get(task.floor())).tell(new FloorMessage.Begin(task, chosen, why));
    changed = true;
  }

  private void requeue(TransportTask task) {
    handedOver.remove(task.id());
    queue.add(task, clock.instant());
    changed = true;
    due.add(task.floor());
  }

  private List<Candidate> candidates(String floor) {
    ManagerMessage.FloorReport report = reports.get(floor);
    if (report == null) {
      return List.of();
    }
    Set<String> promised =
        handedOver.values().stream().flatMap(t -> t.robots().stream()).collect(Collectors.toSet());
    return Candidates.of(requireNonNull(maps.get(floor)), report.robots(), promised);
  }

  // --- the picture ------------------------------------------------------------------------------

  private void tick(Instant now) {
    floors.values().forEach(f -> f.tell(new FloorMessage.Tick(now)));
    beginRounds();
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
    firstOfQueue().forEach(t -> tasks.put(t.id(), t));
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
            queue.size(),
            floorViews(),
            alerts));
  }

  private List<TaskView> firstOfQueue() {
    Map<String, WaitingReason> byFloor = new HashMap<>();
    reports
        .keySet()
        .forEach(f -> byFloor.put(f, new WaitingReason(candidates(f), Travel.STRAIGHT)));
    return queue
        .first(QUEUED_SHOWN)
        .map(q -> waiting(q.task(), reason(q, byFloor.get(q.task().floor())), q.since()))
        .toList();
  }

  /** What the last round said; of a task that it did not look at, what is plain without one. */
  private String reason(TaskQueue.Queued queued, @Nullable WaitingReason plain) {
    String said = reasons.getOrDefault(queued.task().floor(), Map.of()).get(queued.task().id());
    if (said != null) {
      return said;
    }
    return plain == null ? NOT_LOOKED_AT : plain.of(queued.job());
  }

  private static TaskView waiting(TransportTask task, String why, Instant since) {
    return new TaskView(task, TaskState.QUEUED, false, List.of(), why, null, since);
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
