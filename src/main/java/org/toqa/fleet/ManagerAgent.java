package org.toqa.fleet;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
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
import org.toqa.allocation.PlaceUse;
import org.toqa.allocation.Situation;
import org.toqa.allocation.Situation.Given;
import org.toqa.allocation.Standing;
import org.toqa.allocation.Travel;
import org.toqa.allocation.WaitingReason;
import org.toqa.fleet.FleetStore.OpenTask;
import org.toqa.fleet.FleetStore.StoreException;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.link.RobotLinks;
import org.toqa.mission.Mission;
import org.toqa.mission.Objection;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

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

  private static final Duration DEADLINES_EVERY = Duration.ofSeconds(1);

  private static final Sentence NOT_LOOKED_AT = Phrase.LOOKING_FOR_ROBOT.with();

  private final FleetStore store;
  private final StoreWriter writer;
  private final StoreWatch storeWatch;
  private final TaskIntake intake;
  private final RobotIntake robotIntake;
  private final InstantSource clock;
  private final Allocator allocator;
  private final OrderCheck check;
  private final SnapshotBoard board;
  private final Map<String, ActorRef<FloorMessage>> floors = new LinkedHashMap<>();
  private final Map<String, FloorMap> maps = new HashMap<>();
  private final Map<String, FloorDistances> distances = new HashMap<>();

  private final Holds holds;
  private final TaskQueue queue = new TaskQueue();
  private final Exchanges exchanges = new Exchanges();
  private final DeadlineWatch deadlines;
  private Instant nextLookAtDeadlines = Instant.MIN;
  private final Map<String, RobotRecord> robots = new TreeMap<>();
  private final Map<String, ManagerMessage.FloorReport> reports = new HashMap<>();
  private final Map<Long, TaskView> handedOver = new HashMap<>();
  private final Deque<TaskView> ended = new ArrayDeque<>();

  /** By floor: what its robots were last seen to be kept by. */
  private final Map<String, Map<String, Standing>> standings = new HashMap<>();

  /** By floor: which of its places were last seen to be in use. */
  private final Map<String, List<PlaceUse>> placesSeen = new HashMap<>();

  /** By floor and task: what the last round said of those that wait. */
  private final Map<String, Map<Long, Sentence>> reasons = new HashMap<>();

  /** Tasks for several robots that have no room round the load, and why. */
  private final Map<Long, Sentence> roomless = new HashMap<>();

  /** Floors whose robots or tasks have changed since the last round began. */
  private final Set<String> due = new HashSet<>();

  /** Floors with a round under way. */
  private final Set<String> deciding = new HashSet<>();

  /** Floors whose tick is under way. */
  private final Set<String> ticking = new HashSet<>();

  private boolean changed = true;

  static Behavior<ManagerMessage> of(
      List<FloorMap> floors,
      FleetStore store,
      RobotLinks links,
      Allocator allocator,
      FleetRules rules,
      InstantSource clock,
      Instant now,
      SnapshotBoard board) {
    return AgentFleet.goingOn(
        Behaviors.setup(
            context ->
                new ManagerAgent(
                    context, floors, store, links, allocator, rules, clock, now, board)));
  }

  private ManagerAgent(
      ActorContext<ManagerMessage> context,
      List<FloorMap> floorMaps,
      FleetStore store,
      RobotLinks links,
      Allocator allocator,
      FleetRules rules,
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
    this.intake = new TaskIntake(store, writer);
    this.robotIntake = new RobotIntake(links, store, writer, clock);
    ActorRef<ManagerMessage> self = context.getSelf();
    this.storeWatch =
        new StoreWatch(store, answers -> self.tell(new ManagerMessage.StoreWatched(answers)));
    List<RobotRecord> stored = store.robots();
    List<OpenTask> open = store.openTasks();
    this.deadlines =
        new DeadlineWatch(
            rules.pace(), open.stream().map(t -> t.mission().id()).collect(Collectors.toSet()));
    Set<String> outOfService = store.outOfService();
    Set<String> held = store.held();
    List<ChargeRecord> charges = store.charges();
    this.holds = new Holds(store, writer, clock, self, floors);
    stored.forEach(r -> robots.put(r.name(), r));
    for (OpenTask t : open) {
      if (t.mission().state() == TaskState.QUEUED) {
        queue.add(t.mission(), t.changedAt(), true);
      }
    }
    for (FloorMap floor : floorMaps) {
      FloorMemory memory =
          new FloorMemory(
              stored.stream().filter(r -> r.floor().equals(floor.name())).toList(),
              outOfService,
              held,
              charges,
              holds.pause(),
              holds.of(floor.name()),
              open.stream()
                  .filter(t -> t.mission().state() != TaskState.QUEUED)
                  .filter(t -> t.mission().task().floor().equals(floor.name()))
                  .toList());
      ActorRef<FloorMessage> agent =
          context.spawn(
              FloorAgent.of(floor, memory, store, links, rules, clock, now, context.getSelf()),
              "floor-" + floors.size());
      floors.put(floor.name(), agent);
      maps.put(floor.name(), floor);
      distances.put(floor.name(), new FloorDistances(floor.grid()));
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
      case ManagerMessage.SubmitAll m -> submitAll(m);
      case ManagerMessage.CheckAll m -> checkAll(m);
      case ManagerMessage.AllStored m -> allStored(m);
      case ManagerMessage.PreviewTask m -> preview(m);
      case ManagerMessage.TaskStored m -> taskStored(m);
      case ManagerMessage.AddRobot m -> addRobot(m);
      case ManagerMessage.RobotStored m -> robotStored(m);
      case ManagerMessage.RobotJoined m -> joined(m);
      case ManagerMessage.RobotNotStored m -> robots.remove(m.robot());
      case ManagerMessage.RobotNotChanged m -> robots.put(m.robot().name(), m.robot());
      case ManagerMessage.PairRobot m -> pair(m);
      case ManagerMessage.ChangeRobot m -> change(m);
      case ManagerMessage.RobotChanged m -> changed(m);
      case ManagerMessage.RemoveRobot m ->
          tellFloorOf(
              m.robot(),
              m.replyTo(),
              new FloorMessage.RemoveRobot(m.robot(), m.user(), m.replyTo()));
      case ManagerMessage.RobotRemoved m -> removed(m);
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
      case ManagerMessage.Pause m -> {
        holds.pause(m);
        changed = true;
      }
      case ManagerMessage.PauseEnded m -> {
        holds.pauseEnded();
        changed = true;
      }
      case ManagerMessage.HoldFloor m -> holds.hold(m);
      case ManagerMessage.FloorHoldEnded m -> holds.holdEnded(m.floor());
      case ManagerMessage.Returned m -> requeue(m.mission());
      case ManagerMessage.Begun m -> handedOver.remove(m.task());
      case ManagerMessage.NotBegun m -> requeue(m.mission());
      case ManagerMessage.FloorReport m -> reported(m);
      case ManagerMessage.Ticked m -> ticked(m.floor());
      case ManagerMessage.Decided m -> decided(m);
      case ManagerMessage.StoreWatched m -> publish(); // also where simulated time stands still
      case ManagerMessage.Tick m -> tick(m.now());
    }
    return this;
  }

  // --- wishes -----------------------------------------------------------------------------------

  private void submit(ManagerMessage.Submit m) {
    Answer<TransportTask> checked = checked(m.order(), m.user());
    if (checked instanceof Answer.Accepted<TransportTask>(TransportTask task)) {
      store(task, m.key(), m.replyTo());
    } else {
      m.replyTo().tell(StatusReply.success(checked.refusal()));
    }
  }

  private Answer<TransportTask> checked(TaskOrder order, String user) {
    return check.task(order, user, clock.instant(), together());
  }

  /** What all robots carry together, kilograms. */
  private double together() {
    return robots.isEmpty()
        ? Double.MAX_VALUE
        : robots.values().stream().mapToDouble(RobotRecord::maxLoad).sum();
  }

  private void submitAll(ManagerMessage.SubmitAll m) {
    if (!storeWatch.answers()) {
      refuse(m.replyTo());
      return;
    }
    ActorRef<ManagerMessage> self = getContext().getSelf();
    long deadline = TaskIntake.deadline();
    var _ =
        checkApart(m.orders(), m.user())
            .whenComplete(
                (checked, failure) -> {
                  if (failure != null) {
                    m.replyTo().tell(StatusReply.error(failure));
                  } else if (!checked.refusals().isEmpty()) {
                    m.replyTo()
                        .tell(StatusReply.success(new BatchAnswer.Refused(checked.refusals())));
                  } else {
                    intake.take(
                        submissions(checked.tasks(), m.keys()),
                        deadline,
                        stored -> self.tell(new ManagerMessage.AllStored(stored, m.replyTo())),
                        () -> refuse(m.replyTo()));
                  }
                });
  }

  private void checkAll(ManagerMessage.CheckAll m) {
    var _ =
        checkApart(m.orders(), m.user())
            .whenComplete(
                (checked, failure) ->
                    m.replyTo()
                        .tell(
                            failure == null
                                ? StatusReply.success(checked.refusals())
                                : StatusReply.error(failure)));
  }

  private CompletableFuture<BatchCheck.Result> checkApart(List<TaskOrder> orders, String user) {
    BatchCheck batch = new BatchCheck(check.another(), orders, user, clock.instant(), together());
    return CompletableFuture.supplyAsync(
        batch::run, work -> Thread.ofVirtual().name("batch").start(work));
  }

  private static List<Submission> submissions(List<TransportTask> tasks, List<UUID> keys) {
    return IntStream.range(0, tasks.size())
        .mapToObj(i -> new Submission(tasks.get(i), keys.get(i)))
        .toList();
  }

  private void preview(ManagerMessage.PreviewTask m) {
    Answer<TransportTask> checked = checked(m.order(), m.user());
    if (!(checked instanceof Answer.Accepted<TransportTask>(TransportTask task))) {
      m.replyTo().tell(StatusReply.success(checked.refusal()));
      return;
    }
    FloorMap floor = requireNonNull(maps.get(task.floor()));
    Situation situation =
        situation(
            floor, List.of(TaskQueue.job(task, task.start())), List.of(), candidates(floor.name()));
    var _ =
        CompletableFuture.supplyAsync(
                () -> new TaskForesight(allocator, floor).of(task, situation),
                work -> Thread.ofVirtual().name("preview").start(work))
            .whenComplete(
                (preview, failure) ->
                    m.replyTo()
                        .tell(
                            failure == null
                                ? StatusReply.success(new Answer.Accepted<>(preview))
                                : StatusReply.error(failure)));
  }

  private void store(
      TransportTask task, UUID key, ActorRef<StatusReply<Answer<TaskView>>> replyTo) {
    if (!storeWatch.answers()) {
      refuse(replyTo);
      return;
    }
    ActorRef<ManagerMessage> self = getContext().getSelf();
    intake.take(
        List.of(new Submission(task, key)),
        TaskIntake.deadline(),
        stored -> self.tell(new ManagerMessage.TaskStored(stored.getFirst(), replyTo)),
        () -> refuse(replyTo));
  }

  private static <T> void refuse(ActorRef<StatusReply<T>> replyTo) {
    replyTo.tell(
        StatusReply.error(
            new StoreException(
                "The database does not answer, so nothing was accepted; try again.", null)));
  }

  private void taskStored(ManagerMessage.TaskStored m) {
    Queueing queued = enqueue(List.of(m.task()));
    answer(queued, m.replyTo(), new Answer.Accepted<>(queued.tasks().getFirst()));
  }

  private void allStored(ManagerMessage.AllStored m) {
    Queueing queued = enqueue(m.tasks());
    answer(queued, m.replyTo(), new BatchAnswer.Accepted(queued.tasks()));
  }

  /**
   * New tasks have come into the queue.
   *
   * @param late lines for the history of those that will be late
   */
  private record Queueing(List<TaskView> tasks, List<EventRecord> late) {}

  private Queueing enqueue(List<TransportTask> tasks) {
    List<TaskView> views = new ArrayList<>();
    List<EventRecord> late = new ArrayList<>();
    for (TransportTask task : tasks) {
      queue.add(Mission.queued(task), task.createdAt(), true);
      due.add(task.floor());
      TaskView queued = view(task.id(), NOT_LOOKED_AT);
      lookAtDeadline(queued).ifPresent(late::add);
      views.add(deadlines.told(queued));
    }
    changed = true;
    return new Queueing(views, late);
  }

  private <T> void answer(Queueing queued, ActorRef<StatusReply<T>> replyTo, T answer) {
    if (queued.late().isEmpty()) {
      replyTo.tell(StatusReply.success(answer));
    } else {
      writer.write(
          () -> store.addEvents(queued.late()), () -> replyTo.tell(StatusReply.success(answer)));
    }
  }

  // --- deadlines --------------------------------------------------------------------------------

  private void lookAtDeadlines(Instant now) {
    if (now.isBefore(nextLookAtDeadlines)) {
      return;
    }
    nextLookAtDeadlines = now.plus(DEADLINES_EVERY);
    List<EventRecord> late =
        Stream.concat(
                queue.first(LOOKED_AT).map(q -> view(q, NOT_LOOKED_AT)),
                reports.values().stream().flatMap(r -> r.missions().stream()))
            .flatMap(task -> lookAtDeadline(task).stream())
            .toList();
    if (!late.isEmpty()) {
      changed = true;
      writer.write(() -> store.addEvents(late), () -> {});
    }
  }

  /** A line for the history if it has just become clear that the task will be late. */
  private Optional<EventRecord> lookAtDeadline(TaskView task) {
    if (!DeadlineWatch.isDue(task)) {
      return Optional.empty();
    }
    String floor = task.task().floor();
    Map<Long, TaskView> here =
        missions(floor).stream().collect(Collectors.toMap(TaskView::id, t -> t));
    Forecast forecast = new Forecast(requireNonNull(distances.get(floor)));
    Instant at = clock.instant();
    return deadlines
        .look(task, forecast.of(task, robotViews(floor), here), at)
        .map(
            sentence ->
                new EventRecord(at, "task.late", task.id(), null, EventRecord.SYSTEM, sentence));
  }

  // --- robots -----------------------------------------------------------------------------------

  private void addRobot(ManagerMessage.AddRobot m) {
    Answer<RobotRecord> checked = check.robot(m.order(), List.copyOf(robots.values()));
    if (checked instanceof Answer.Accepted<RobotRecord>(RobotRecord robot)) {
      take(robot, m);
    } else {
      m.replyTo().tell(StatusReply.success(checked.refusal()));
    }
  }

  private void take(RobotRecord robot, ManagerMessage.AddRobot m) {
    robots.put(robot.name(), robot); // the name and its parking point are taken from now on
    ActorRef<ManagerMessage> self = getContext().getSelf();
    robotIntake.take(
        robot,
        m.order().code(),
        new RobotIntake.Wish(
            m.user(),
            "robot.added",
            Phrase.ROBOT_ADDED.with(m.user(), robot.name()),
            new RobotAsker(
                m.replyTo(),
                stored -> self.tell(new ManagerMessage.RobotStored(stored, m.replyTo())),
                () -> self.tell(new ManagerMessage.RobotNotStored(robot.name())))));
  }

  private void pair(ManagerMessage.PairRobot m) {
    RobotRecord robot = robots.get(m.robot());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(FloorState.unknown(m.robot())));
      return;
    }
    ActorRef<ManagerMessage> self = getContext().getSelf();
    PairingOrder order = m.order();
    robotIntake.take(
        robot.at(order.host(), order.port()),
        order.code(),
        new RobotIntake.Wish(
            m.user(),
            "robot.paired",
            Phrase.ROBOT_PAIRED.with(m.user(), robot.name()),
            new RobotAsker(
                m.replyTo(),
                stored -> self.tell(new ManagerMessage.RobotChanged(stored, m.replyTo())),
                () -> {})));
  }

  private void change(ManagerMessage.ChangeRobot m) {
    RobotRecord robot = robots.get(m.robot());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(FloorState.unknown(m.robot())));
      return;
    }
    Answer<RobotRecord> checked = check.change(robot, m.change(), List.copyOf(robots.values()));
    if (!(checked instanceof Answer.Accepted<RobotRecord>(RobotRecord changed))) {
      m.replyTo().tell(StatusReply.success(checked.refusal()));
      return;
    }
    robots.put(changed.name(), changed); // its parking point is taken from now on
    ActorRef<ManagerMessage> self = getContext().getSelf();
    robotIntake.take(
        changed,
        null,
        new RobotIntake.Wish(
            m.user(),
            "robot.changed",
            Phrase.ROBOT_CHANGED.with(m.user(), robot.name()),
            new RobotAsker(
                m.replyTo(),
                stored -> self.tell(new ManagerMessage.RobotChanged(stored, m.replyTo())),
                () -> self.tell(new ManagerMessage.RobotNotChanged(robot)))));
  }

  private void changed(ManagerMessage.RobotChanged m) {
    robots.put(m.robot().name(), m.robot());
    due.add(m.robot().floor()); // who was too weak or too far away may not be any more
    tellFloorOf(
        m.robot().name(), m.replyTo(), new FloorMessage.RobotChanged(m.robot(), m.replyTo()));
  }

  /** Whoever removed the robot does not find it in the picture. */
  private void removed(ManagerMessage.RobotRemoved m) {
    robots.remove(m.robot().name());
    publish();
    m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(m.robot())));
  }

  private void robotStored(ManagerMessage.RobotStored m) {
    robots.put(m.robot().name(), m.robot());
    floorAgent(m.robot().floor())
        .ifPresent(f -> f.tell(new FloorMessage.RobotJoined(m.robot(), m.replyTo())));
  }

  /** Whoever asked for the robot finds it in the picture. */
  private void joined(ManagerMessage.RobotJoined m) {
    publish();
    m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(m.robot())));
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
    Optional<TaskQueue.Queued> queued = queue.get(m.task());
    if (queued.isPresent()) {
      wished(queued.get(), m);
      return;
    }
    floorOf(m.task())
        .ifPresentOrElse(
            floor -> floor.tell(new FloorMessage.Wished(m.task(), m.wish(), m.replyTo())),
            () ->
                m.replyTo()
                    .tell(
                        StatusReply.success(
                            new Answer.Conflict<>(Phrase.TASK_HAS_ENDED.with(m.task()), null))));
  }

  private void wished(TaskQueue.Queued queued, ManagerMessage.Wished m) {
    Optional<Objection> objection = queued.mission().objectionTo(m.wish());
    if (objection.isPresent()) {
      m.replyTo().tell(StatusReply.success(Answer.conflict(objection.get())));
      return;
    }
    Mission.Step step = queued.mission().on(m.wish());
    Instant at = clock.instant();
    Mission mission = step.mission();
    TaskView next;
    if (mission.state().isEnded()) {
      queue.remove(m.task());
      next = TaskView.of(mission, null, at);
      shelve(next);
    } else {
      queue.add(mission, queued.since(), !step.changed() && queued.stored());
      next = view(m.task(), NOT_LOOKED_AT);
    }
    changed = true;
    ActorRef<ManagerMessage> self = getContext().getSelf();
    if (step.changed()) {
      writer.write(
          () -> store.saveMission(mission, at, EventRecord.of(step, m.wish(), at)),
          () -> self.tell(new ManagerMessage.WishStored(mission)));
    }
    writer.write(
        () -> {}, () -> m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(next))));
  }

  private void wishStored(Mission mission) {
    queue
        .get(mission.id())
        .filter(queued -> queued.mission().equals(mission))
        .ifPresent(queued -> queue.add(mission, queued.since(), true));
    due.add(mission.task().floor());
  }

  private Optional<ActorRef<FloorMessage>> floorOf(long task) {
    return Stream.concat(
            handedOver.values().stream(),
            reports.values().stream().flatMap(r -> r.missions().stream()))
        .filter(t -> t.id() == task)
        .findFirst()
        .flatMap(t -> floorAgent(t.task().floor()));
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
                    StatusReply.success(new Answer.Unknown<>(Phrase.NO_SUCH_ROBOT.with(robot)))));
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
    List<PlaceUse> inUse = placesInUse(m.floor().name());
    boolean isNews = !now.equals(standings.put(m.floor().name(), now));
    if (!inUse.equals(placesSeen.put(m.floor().name(), inUse)) || isNews) {
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
    List<Given> given =
        exchanges.given(missions(floor.name()), robotViews(floor.name()), clock.instant());
    double strongest = strongest(robotsHere, given);
    double strongestOfAll = robotsHere.stream().mapToDouble(Candidate::maxLoad).max().orElse(0);
    boolean isAnyFree = strongest > 0;
    List<Job> jobs =
        queue.first(
            floor.name(),
            job ->
                job.load() <= strongest
                    || (isAnyFree
                        && job.load() > strongestOfAll
                        && !roomless.containsKey(job.id())),
            LOOKED_AT);
    if (jobs.isEmpty()) {
      reasons.remove(floor.name());
      changed = true;
    }
    if (jobs.isEmpty() && given.isEmpty()) {
      return;
    }
    deciding.add(floor.name());
    Situation situation = situation(floor, jobs, given, robotsHere);
    getContext()
        .pipeToSelf(
            CompletableFuture.supplyAsync(
                () -> allocator.allocate(situation),
                round -> Thread.ofVirtual().name("allocation-" + floor.name()).start(round)),
            (decisions, failure) -> decided(floor.name(), decisions, failure));
  }

  /** What a robot that is free, or may be by an exchange, carries; nothing while none is free. */
  private static double strongest(List<Candidate> robotsHere, List<Given> given) {
    Set<String> holders = given.stream().map(Given::robot).collect(Collectors.toSet());
    return robotsHere.stream().noneMatch(r -> r.standing() == Standing.FREE)
        ? Double.NEGATIVE_INFINITY
        : robotsHere.stream()
            .filter(r -> r.standing() == Standing.FREE || holders.contains(r.robot()))
            .mapToDouble(Candidate::maxLoad)
            .max()
            .orElse(Double.NEGATIVE_INFINITY);
  }

  private List<RobotView> robotViews(String floor) {
    ManagerMessage.FloorReport report = reports.get(floor);
    return report == null ? List.of() : report.robots();
  }

  private Situation situation(
      FloorMap floor, List<Job> jobs, List<Given> given, List<Candidate> robotsHere) {
    OccupancyGrid grid = floor.grid();
    Vec2 size = new Vec2(grid.width(), grid.height()).times(grid.resolution());
    return new Situation(
        clock.instant(),
        grid.origin(),
        grid.origin().plus(size),
        requireNonNull(distances.get(floor.name())),
        chargers(floor),
        jobs,
        given,
        robotsHere,
        placesInUse(floor.name()));
  }

  private List<PlaceUse> placesInUse(String floor) {
    Map<Long, TaskView> begun = new TreeMap<>();
    handedOver.values().stream()
        .filter(t -> t.task().floor().equals(floor))
        .forEach(t -> begun.put(t.id(), t));
    missions(floor).forEach(t -> begun.put(t.id(), t));
    return PlacesInUse.of(begun.values().stream(), robotViews(floor));
  }

  private static List<Vec2> chargers(FloorMap floor) {
    return floor.charging().stream().map(Place::position).toList();
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
    ActorRef<FloorMessage> floor = requireNonNull(floors.get(m.floor()));
    Set<String> free = exchange(floor, m);
    Map<Long, Sentence> waiting = new HashMap<>();
    for (Decision decision : m.decisions()) {
      switch (decision) {
        case Decision.Assigned(long id, List<String> chosen, Sentence why) -> {
          Optional<Sentence> objection = objection(id, chosen.size(), m.floor());
          if (objection.isPresent()) {
            roomless.put(id, objection.get());
            due.add(m.floor());
          } else if (free.containsAll(chosen)) {
            mayBegin(id).ifPresent(mission -> handOver(mission, chosen, why));
          } else if (queue.get(id).isPresent()) {
            due.add(m.floor());
          }
        }
        case Decision.Waits(long id, Sentence why, List<String> drained) -> {
          waiting.put(id, why);
          if (!drained.isEmpty()) {
            floor.tell(new FloorMessage.Recharge(drained, id));
          }
        }
      }
    }
    roomless.keySet().removeIf(task -> queue.get(task).isEmpty());
    reasons.put(m.floor(), waiting);
  }

  private Optional<Sentence> objection(long task, int robots, String floor) {
    TeamRoom room = new TeamRoom(requireNonNull(maps.get(floor)).grid());
    return queue.get(task).flatMap(queued -> room.objection(queued.mission(), robots));
  }

  /**
   * Lets robots change tasks that are not begun.
   *
   * @return who is free for another task then
   */
  private Set<String> exchange(ActorRef<FloorMessage> floor, ManagerMessage.Decided m) {
    Set<String> free =
        candidates(m.floor()).stream()
            .filter(r -> r.standing() == Standing.FREE)
            .map(Candidate::robot)
            .collect(Collectors.toCollection(HashSet::new));
    List<FloorMessage.Move> moves =
        exchanges.moves(m.decisions(), missions(m.floor()), free, clock.instant());
    if (!moves.isEmpty()) {
      floor.tell(new FloorMessage.Exchange(moves));
      moves.forEach(move -> free.add(move.from()));
      moves.forEach(move -> free.remove(move.to()));
    }
    return free;
  }

  private List<TaskView> missions(String floor) {
    ManagerMessage.FloorReport report = reports.get(floor);
    return report == null ? List.of() : report.missions();
  }

  /** Takes it out of the queue, unless it was cancelled or held meanwhile. */
  private Optional<Mission> mayBegin(long task) {
    return queue.get(task).filter(TaskQueue.Queued::mayBegin).flatMap(q -> queue.remove(task));
  }

  private void handOver(Mission mission, List<String> chosen, Sentence why) {
    handedOver.put(
        mission.id(), TaskView.of(mission.assign(chosen, why).mission(), null, clock.instant()));
    requireNonNull(floors.get(mission.task().floor()))
        .tell(new FloorMessage.Begin(mission, chosen, why));
    changed = true;
  }

  private void requeue(Mission mission) {
    handedOver.remove(mission.id());
    queue.add(mission, clock.instant(), true);
    changed = true;
    due.add(mission.task().floor());
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

  /** What changes is in the picture when every floor has done its tick, or at the next tick. */
  private void tick(Instant now) {
    if (!ticking.isEmpty() || floors.isEmpty()) {
      publishWhatChanged();
    }
    floors.values().forEach(f -> f.tell(new FloorMessage.Tick(now)));
    ticking.addAll(floors.keySet());
    beginRounds();
    lookAtDeadlines(now);
  }

  private void ticked(String floor) {
    ticking.remove(floor);
    if (ticking.isEmpty()) {
      publishWhatChanged();
    }
  }

  private void publishWhatChanged() {
    if (changed) {
      publish();
    }
  }

  private void publish() {
    changed = false;
    List<RobotView> views = new ArrayList<>();
    Map<Long, TaskView> tasks = new HashMap<>();
    Set<Sentence> alerts = new LinkedHashSet<>();
    if (!storeWatch.answers()) {
      alerts.add(StoreWatch.AWAY);
    }
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
        tasks.values().stream()
            .map(deadlines::told)
            .sorted(Comparator.comparingLong(TaskView::id).reversed())
            .toList();
    board.publish(
        new FleetSnapshot(
            board.latest().version() + 1,
            clock.instant(),
            views,
            newestFirst,
            queue.size(),
            floorViews(),
            holds.pause(),
            List.copyOf(alerts)));
  }

  private List<TaskView> firstOfQueue() {
    Map<String, WaitingReason> byFloor = new HashMap<>();
    reports
        .keySet()
        .forEach(
            f ->
                byFloor.put(
                    f,
                    new WaitingReason(
                        candidates(f), Travel.STRAIGHT, chargers(requireNonNull(maps.get(f))))));
    return queue
        .first(QUEUED_SHOWN)
        .map(q -> view(q, reason(q, byFloor.get(q.task().floor()))))
        .toList();
  }

  /** What the last round said; of a task that it did not look at, what is plain without one. */
  private Sentence reason(TaskQueue.Queued queued, @Nullable WaitingReason plain) {
    Sentence noRoom = roomless.get(queued.task().id());
    if (noRoom != null) {
      return noRoom;
    }
    Sentence said = reasons.getOrDefault(queued.task().floor(), Map.of()).get(queued.task().id());
    if (said != null) {
      return said;
    }
    return plain == null ? NOT_LOOKED_AT : plain.of(queued.job());
  }

  private TaskView view(long queued, Sentence why) {
    return view(queue.get(queued).orElseThrow(), why);
  }

  private static TaskView view(TaskQueue.Queued queued, Sentence why) {
    Mission mission = queued.mission();
    return TaskView.of(mission, mission.held() ? Phrase.ON_HOLD.with() : why, queued.since());
  }

  private List<FloorView> floorViews() {
    return floors.keySet().stream()
        .flatMap(floor -> Stream.ofNullable(reports.get(floor)))
        .map(ManagerMessage.FloorReport::floor)
        .toList();
  }

  private Behavior<ManagerMessage> closed() {
    storeWatch.close();
    writer.close();
    return this;
  }
}
