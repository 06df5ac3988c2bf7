package org.toqa.fleet.supervision;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.arm.Arm;
import org.toqa.fleet.Answer;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.FloorListener;
import org.toqa.fleet.FloorView.BoxView;
import org.toqa.fleet.MapProblem;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.fleet.TaskArchive;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.supervision.Supervision.State;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.link.message.AgentMessage.CameraView;
import org.toqa.mission.ArmHandling;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Reply;
import org.toqa.mission.TaskState;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Runs the supervisions of all floors: looks at the fleet's pictures many times a second, and does
 * what follows from them by the fleet's own orders and commands.
 *
 * <ol>
 *   <li>What the cameras see is noted; the supervisor is sent where something is unseen.
 *   <li>A box that is found is stored, then ordered by a key that follows from run, box and try, so
 *       that it is ordered once whatever ends in between. Until it is carried it is in the way of
 *       robots, and one that lies behind others is ordered when they are gone.
 *   <li>What an arm has weighed as too heavy is stored, then its task is given back and the box
 *       ordered for two, before all others.
 *   <li>When every box lies at its target, the supervision is done.
 * </ol>
 *
 * One thread does all of it, also what people ask; anybody may read what it found last.
 */
public final class Supervisor implements FloorListener, AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(Supervisor.class);
  private static final Duration PERIOD = Duration.ofMillis(100);
  private static final Duration LIMIT = Duration.ofSeconds(12);
  private static final Duration END_LIMIT = Duration.ofSeconds(5);

  /** Of the fleet's time: what was refused may be possible by then. */
  private static final Duration RETRY_AFTER = Duration.ofSeconds(60);

  /** Of the fleet's time: where it has not come by then it does not come. */
  private static final Duration DRIVE_LIMIT = Duration.ofMinutes(3);

  /** Of real time, between what is stored only so that less is looked at anew. */
  private static final Duration SEEN_PERIOD = Duration.ofSeconds(2);

  /** Metres: it has come there. */
  private static final double ARRIVED = 0.1;

  /** Metres from a box within which robots that carry it together come to it. */
  private static final double BESIDE = 0.5;

  /** Of a box in one look; the fleet checks paths and room of each. */
  private static final int MOST_TRIES = 20;

  /** A level of priority counts as a minute of waiting: before all boxes for one. */
  private static final int FOR_TWO = 60;

  private final SupervisionStore store;
  private final Fleet fleet;
  private final TaskArchive archive;
  private final InstantSource fleetClock;
  private final InstantSource wallClock;
  private final ScheduledExecutorService thread =
      Executors.newSingleThreadScheduledExecutor(
          Thread.ofPlatform().daemon().name("supervisor").factory());

  /** By floor; for any reader. */
  private final Map<String, Supervision> latest = new ConcurrentHashMap<>();

  /** By floor, of those that run; for any reader. */
  private final Map<String, SupervisionReport> reports = new ConcurrentHashMap<>();

  /** By floor, of those that run. */
  private final Map<String, Watch> watches = new HashMap<>();

  /** What is known of a running one beside what is stored. */
  private static final class Watch {
    final FloorMap floor;
    final SeenArea seen;
    final DrivableArea area;
    final Map<Integer, Refusal> refusals = new HashMap<>();

    /** By box that was not refused everywhere yet, with which of its orders to go on. */
    final Map<Integer, Integer> nextOrders = new HashMap<>();

    /** By box, where those lie that are in the way of robots. */
    Map<Integer, Vec2> lying = Map.of();

    /** By box that no robot gets to now, what lay in the way. */
    final Map<Integer, Map<Integer, Vec2>> behind = new HashMap<>();

    @Nullable Instant lastLook;
    Instant seenStoredAt = Instant.MIN;
    @Nullable Vec2 view;
    Instant sentAt = Instant.MIN;

    Watch(FloorMap floor, double clearance, String seen) {
      this.floor = floor;
      this.seen = new SeenArea(floor, clearance, seen);
      this.area = new DrivableArea(floor, clearance);
    }

    void setLying(List<BoxView> boxes) {
      Map<Integer, Vec2> now = new TreeMap<>();
      boxes.stream()
          .filter(box -> !box.delivered())
          .forEach(box -> now.put(box.box(), box.where()));
      lying = now;
      seen.setBoxes(List.copyOf(now.values()));
    }

    List<Vec2> lyingBut(int box) {
      return lying.entrySet().stream()
          .filter(e -> e.getKey() != box)
          .map(Map.Entry::getValue)
          .toList();
    }

    /** By box, why it was refused. */
    Map<Integer, Sentence> reasons() {
      Map<Integer, Sentence> reasons = new TreeMap<>();
      refusals.forEach((box, refusal) -> reasons.put(box, refusal.why()));
      return reasons;
    }
  }

  private record Refusal(Instant at, Sentence why) {}

  /**
   * @param fleetClock simulated time, where robots are simulated
   */
  public Supervisor(
      SupervisionStore store,
      Fleet fleet,
      TaskArchive archive,
      InstantSource fleetClock,
      InstantSource wallClock) {
    this.store = store;
    this.fleet = fleet;
    this.archive = archive;
    this.fleetClock = fleetClock;
    this.wallClock = wallClock;
  }

  /** Knows what is stored. To be called once, before all else. */
  public void recover() {
    store.supervisions().forEach(stored -> latest.put(stored.floor(), stored));
  }

  /** Looks again and again from now on. To be called once. */
  public void begin() {
    var _ =
        thread.scheduleWithFixedDelay(
            this::look, PERIOD.toNanos(), PERIOD.toNanos(), TimeUnit.NANOSECONDS);
  }

  /** The last one of a floor. */
  public Optional<Supervision> latest(String floor) {
    return Optional.ofNullable(latest.get(floor));
  }

  /** The names of the floors on which one works that this user began, in their order. */
  public List<String> floorsOf(String user) {
    return latest.values().stream()
        .filter(each -> each.isRunning() && each.user().equals(user))
        .map(Supervision::floor)
        .sorted()
        .toList();
  }

  /** What a person must look at; empty: nothing. */
  public Optional<Sentence> warning() {
    return reports.values().stream()
        .flatMap(report -> Stream.ofNullable(report.need()))
        .findFirst();
  }

  /** The same of one floor. */
  public Optional<Sentence> warning(String floor) {
    return report(floor).map(SupervisionReport::need);
  }

  /** How the one that runs on a floor gets on; empty: none runs, or it was not looked at yet. */
  public Optional<SupervisionReport> report(String floor) {
    return Optional.ofNullable(reports.get(floor));
  }

  /** Lets a supervisor and its workers begin, where none is at work on the floor. */
  public CompletionStage<Answer<Supervision>> start(SupervisionOrder order, String user) {
    return onThread(
        () -> {
          Supervision before = latest.get(order.floor());
          if (before != null && before.isRunning()) {
            return new Answer.Conflict<>(Phrase.SUPERVISION_RUNS.with(order.floor()), null);
          }
          Optional<Answer<Supervision>> objection =
              SupervisionCheck.objection(order, fleet.floors(), fleet.snapshots().latest());
          if (objection.isPresent()) {
            return objection.get();
          }
          Map<Integer, SupervisedBox> boxes = new HashMap<>();
          order
              .targets()
              .forEach((number, target) -> boxes.put(number, SupervisedBox.unseen(number, target)));
          Supervision begun =
              new Supervision(
                  order.floor(),
                  UUID.randomUUID().toString(),
                  order.supervisor(),
                  order.workers(),
                  order.overlaps(),
                  user,
                  State.RUNNING,
                  wallClock.instant(),
                  null,
                  0,
                  boxes,
                  "");
          watches.remove(order.floor());
          save(
              begun,
              event(
                  begun,
                  EventKind.SUPERVISION_BEGAN,
                  user,
                  Phrase.SUPERVISION_BEGAN.with(
                      user, order.supervisor(), order.targets().size(), order.floor())));
          return new Answer.Accepted<>(begun);
        });
  }

  /**
   * Ends the one of a floor: what no robot has is cancelled, and what is under way is carried to
   * its end.
   */
  public CompletionStage<Answer<Supervision>> stop(String floor, String user) {
    return onThread(
        () -> {
          Supervision before = latest.get(floor);
          if (before == null || !before.isRunning()) {
            return new Answer.Conflict<>(Phrase.SUPERVISION_RUNS_NOT.with(floor), null);
          }
          Supervision stopped = before.ended(State.STOPPED, wallClock.instant());
          save(
              stopped,
              event(
                  stopped,
                  EventKind.SUPERVISION_STOPPED,
                  user,
                  Phrase.SUPERVISION_STOPPED.with(user, floor)));
          end(floor);
          for (SupervisedBox box : stopped.boxes().values()) {
            Long task = box.task();
            if (task != null
                && archive.task(task).filter(t -> t.state() == TaskState.QUEUED).isPresent()) {
              command(task, new MissionEvent.Cancel(user, null));
            }
          }
          return new Answer.Accepted<>(stopped);
        });
  }

  @Override
  public Optional<Sentence> objectionToRemoval(String floor) {
    return latest(floor)
        .filter(Supervision::isRunning)
        .map(_ -> Phrase.SUPERVISION_RUNS.with(floor));
  }

  @Override
  public List<MapProblem> mapProblems(String floor, FloorDrawing drawing) {
    Optional<Supervision> running = latest(floor).filter(Supervision::isRunning);
    Optional<FloorMap> map =
        fleet.floors().stream().filter(each -> each.name().equals(floor)).findFirst();
    Optional<SnapshotFeed> feed = fleet.snapshots(floor);
    return running.isEmpty() || map.isEmpty() || feed.isEmpty()
        ? List.of()
        : SupervisionCheck.mapProblems(running.get(), map.get(), drawing, feed.get().latest());
  }

  @Override
  public void floorRemoved(String floor) {
    onThread(
            () -> {
              latest.remove(floor);
              watches.remove(floor);
              reports.remove(floor);
              store.remove(floor);
              return floor;
            })
        .toCompletableFuture()
        .orTimeout(LIMIT.toMillis(), TimeUnit.MILLISECONDS)
        .join();
  }

  private void end(String floor) {
    watches.remove(floor);
    reports.remove(floor);
    fleet.showBoxes(floor, List.of());
  }

  /**
   * Boxes that were not found are looked for everywhere once more, and refused ones tried again.
   */
  public CompletionStage<Answer<Supervision>> lookAgain(String floor, String user) {
    return onThread(
        () -> {
          Supervision before = latest.get(floor);
          if (before == null || !before.isRunning()) {
            return new Answer.Conflict<>(Phrase.SUPERVISION_RUNS_NOT.with(floor), null);
          }
          Supervision anew = before.withSeen("");
          save(
              anew,
              event(
                  anew,
                  EventKind.SUPERVISION_LOOKS_AGAIN,
                  user,
                  Phrase.SUPERVISION_LOOKS_AGAIN.with(user, floor)));
          end(floor);
          return new Answer.Accepted<>(anew);
        });
  }

  /**
   * Forgets a box, as a person who has taken it away says. A task of it that no robot has is
   * cancelled first.
   */
  public CompletionStage<Answer<Supervision>> leaveOut(String floor, int number, String user) {
    return onThread(
        () -> {
          Supervision before = latest.get(floor);
          if (before == null || !before.isRunning()) {
            return new Answer.Conflict<>(Phrase.SUPERVISION_RUNS_NOT.with(floor), null);
          }
          SupervisedBox box = before.boxes().get(number);
          if (box == null) {
            return new Answer.Unknown<>(Phrase.SUPERVISION_NO_BOX.with(number, floor));
          }
          if (box.delivered()) {
            return new Answer.Conflict<>(Phrase.SUPERVISION_BOX_DELIVERED.with(number), null);
          }
          if (before.boxes().size() == 1) {
            return new Answer.Conflict<>(Phrase.SUPERVISION_LAST_BOX.with(number), null);
          }
          Long task = box.task();
          Optional<TaskView> open =
              task == null
                  ? Optional.empty()
                  : archive.task(task).filter(t -> !t.state().isEnded());
          if (open.isPresent()
              && !(open.get().state() == TaskState.QUEUED
                  && isDone(open.get().id(), new MissionEvent.Cancel(user, null)))) {
            return new Answer.Conflict<>(
                Phrase.SUPERVISION_BOX_IN_WORK.with(number, open.get().id()), null);
          }
          Supervision without = before.without(number);
          save(
              without,
              event(
                  without,
                  EventKind.SUPERVISION_BOX_LEFT_OUT,
                  user,
                  Phrase.SUPERVISION_BOX_LEFT_OUT.with(user, number, floor)));
          return new Answer.Accepted<>(without);
        });
  }

  private boolean isDone(long task, MissionEvent.OperatorCommand command) {
    return await(fleet.commandTask(task, command)) instanceof Answer.Accepted<TaskView>;
  }

  private <T> CompletionStage<T> onThread(Supplier<T> work) {
    return CompletableFuture.supplyAsync(work, thread);
  }

  /**
   * Looks once at each floor where one works; its own thread does so again and again. A surprise on
   * one floor holds up no other, and is tried again.
   */
  public void look() {
    for (Supervision running : List.copyOf(latest.values())) {
      if (running.isRunning()) {
        try {
          look(running);
        } catch (StoreException e) { // of which people are told elsewhere, once
          log.debug("{}: the supervision waits for the database.", running.floor(), e);
        } catch (RuntimeException | Error e) {
          log.error("{}: the supervision failed; it is tried again.", running.floor(), e);
        }
      }
    }
  }

  private void look(Supervision before) {
    Optional<FleetSnapshot> onFloor = fleet.snapshots(before.floor()).map(SnapshotFeed::latest);
    Optional<FloorMap> floor =
        fleet.floors().stream().filter(f -> f.name().equals(before.floor())).findFirst();
    Optional<RobotView> supervisor =
        onFloor.flatMap(snapshot -> SupervisionRules.robot(snapshot, before.supervisor()));
    if (floor.isEmpty() || supervisor.isEmpty()) {
      Sentence gone = Phrase.SUPERVISION_NO_ROBOT.with(before.supervisor(), before.floor());
      reports.put(before.floor(), new SupervisionReport(gone, gone, Map.of(), false));
      return;
    }
    FleetSnapshot snapshot = onFloor.get();
    Watch watch = watch(before, floor.get(), supervisor.get());
    SupervisionRules rules = new SupervisionRules(threshold(before, snapshot));
    SupervisionRules.Step step =
        rules.step(before, snapshot, secondsSinceLook(watch), archive::task);
    Supervision now = step.next();
    Optional<CameraView> camera = SupervisionRules.view(before, snapshot);
    Pose pose = supervisor.get().telemetry().pose();
    if (step.isMissing()) {
      watch.seen.forget();
      watch.view = null;
    }
    if (camera.isPresent() && pose != null) {
      watch.seen.look(pose.position(), camera.get().range());
    }
    now = stored(before, now, watch);
    List<BoxView> lying = SupervisionRules.lying(now, snapshot);
    watch.setLying(lying);
    fleet.showBoxes(now.floor(), lying);
    for (long task : step.toGiveBack()) {
      command(task, new MissionEvent.Answer(now.user(), Reply.CANCEL));
    }
    for (SupervisedBox box : step.toOrder()) {
      now = order(now, box, watch, snapshot, rules);
    }
    if (now.isAllDelivered()) {
      Supervision done = now.ended(State.DONE, wallClock.instant());
      save(
          done,
          event(
              done,
              EventKind.SUPERVISION_DONE,
              EventRecord.SYSTEM,
              Phrase.SUPERVISION_DONE.with(done.boxes().size(), done.floor())));
      end(done.floor());
      return;
    }
    if (camera.isPresent() && pose != null) {
      search(now, watch, supervisor.get(), pose.position(), camera.get().range(), snapshot);
    }
    reports.put(
        now.floor(),
        SupervisionReport.of(now, supervisor.get(), snapshot, watch.seen, watch.reasons()));
  }

  private Watch watch(Supervision running, FloorMap floor, RobotView supervisor) {
    Watch known = watches.get(running.floor());
    if (known == null || !known.floor.version().equals(floor.version())) {
      double clearance = supervisor.capabilities().footprint() / 2 + floor.margins().robot();
      known = new Watch(floor, clearance, running.seen());
      watches.put(running.floor(), known);
    }
    return known;
  }

  private double secondsSinceLook(Watch watch) {
    Instant now = fleetClock.instant();
    Instant last = watch.lastLook;
    watch.lastLook = now;
    return last == null ? 0 : Math.max(0, Duration.between(last, now).toMillis() / 1e3);
  }

  /** Kilograms that every worker carries alone, of those that are known. */
  private static double threshold(Supervision supervision, FleetSnapshot snapshot) {
    return workers(supervision, snapshot).stream()
        .mapToDouble(
            robot -> {
              Arm arm = robot.capabilities().arm();
              return arm == null ? 0 : Math.min(arm.maxLoad(), robot.maxLoad());
            })
        .filter(kilograms -> kilograms > 0)
        .min()
        .orElse(0);
  }

  static List<RobotView> workers(Supervision supervision, FleetSnapshot snapshot) {
    return supervision.workers().stream()
        .flatMap(name -> SupervisionRules.robot(snapshot, name).stream())
        .toList();
  }

  /** Boxes at once, when they have changed; what was seen and the idle time now and then. */
  private Supervision stored(Supervision before, Supervision now, Watch watch) {
    Instant at = wallClock.instant();
    boolean isTime = watch.seenStoredAt.plus(SEEN_PERIOD).isBefore(at);
    if (!before.boxes().equals(now.boxes()) || isTime) {
      watch.seenStoredAt = at;
      Supervision whole = now.withSeen(watch.seen.text());
      save(whole, List.of());
      return whole;
    }
    latest.put(now.floor(), now);
    return now;
  }

  private void save(Supervision supervision, List<EventRecord> events) {
    store.save(supervision, events);
    latest.put(supervision.floor(), supervision);
  }

  private List<EventRecord> event(
      Supervision supervision, EventKind kind, String who, Sentence text) {
    return List.of(
        new EventRecord(wallClock.instant(), kind, null, supervision.supervisor(), who, text)
            .onFloor(supervision.floor()));
  }

  // --- boxes become tasks ------------------------------------------------------------------------

  private Supervision order(
      Supervision now,
      SupervisedBox box,
      Watch watch,
      FleetSnapshot snapshot,
      SupervisionRules rules) {
    Refusal refusal = watch.refusals.get(box.number());
    if (refusal != null && fleetClock.instant().isBefore(refusal.at().plus(RETRY_AFTER))) {
      return now;
    }
    UUID key = key(now, box);
    if (fleet.isSubmissionPending(key)) {
      return now; // whether its task is there is known later
    }
    Optional<TaskView> known = archive.taskByKey(key);
    if (known.isPresent()) {
      return ordered(now, box, known.get().id());
    }
    Sentence why = Phrase.SUPERVISION_NO_STAND.with();
    if (watch.lying.equals(watch.behind.get(box.number()))) {
      return now;
    }
    List<Vec2> others = watch.lyingBut(box.number());
    List<TaskOrder> orders = orders(now, box, watch, snapshot, rules, others);
    if (orders.isEmpty()
        && !others.isEmpty()
        && !orders(now, box, watch, snapshot, rules, List.of()).isEmpty()) {
      watch.behind.put(box.number(), watch.lying); // until one of them is carried away
      return now;
    }
    Set<Where> failing = new HashSet<>();
    int tries = 0;
    for (int next = watch.nextOrders.getOrDefault(box.number(), 0); next < orders.size(); next++) {
      TaskOrder order = orders.get(next);
      if (failing.contains(order.start()) || failing.contains(order.goal())) {
        continue; // no other end helps
      }
      if (tries++ == MOST_TRIES) {
        watch.nextOrders.put(box.number(), next);
        return now; // others have their turn
      }
      switch (await(fleet.submit(order, now.user(), key))) {
        case Answer.Accepted<TaskView>(TaskView task) -> {
          watch.refusals.remove(box.number());
          watch.nextOrders.remove(box.number());
          return ordered(now, box, task.id());
        }
        case Answer.Rejected<TaskView>(String field, Sentence sentence) -> {
          why = sentence;
          if (isOf(field, "start", "arm.pick")) {
            failing.add(order.start());
          } else if (isOf(field, "goal", "arm.place")) {
            failing.add(order.goal());
          }
        }
        case Answer.Conflict<TaskView>(Sentence sentence, var _) -> why = sentence;
        case Answer.Unknown<TaskView>(Sentence sentence) -> why = sentence;
        case Answer.Outdated<TaskView>() ->
            throw new IllegalStateException("A new task is not outdated.");
        case null -> {
          return now; // the fleet did not answer; it is asked again
        }
      }
    }
    watch.nextOrders.remove(box.number());
    watch.refusals.put(box.number(), new Refusal(fleetClock.instant(), why));
    return now;
  }

  private static boolean isOf(@Nullable String field, String place, String action) {
    return place.equals(field) || action.equals(field);
  }

  private Supervision ordered(Supervision now, SupervisedBox box, long task) {
    Supervision with = now.with(box.orderedAs(task));
    save(with, List.of());
    return with;
  }

  private static UUID key(Supervision supervision, SupervisedBox box) {
    return UUID.nameUUIDFromBytes(
        "box %d of %s, %d"
            .formatted(box.number(), supervision.run(), box.tries())
            .getBytes(StandardCharsets.UTF_8));
  }

  /**
   * All that may be ordered of the box, the better ones first; the fleet checks paths and room.
   *
   * @param others that robots drive round, metres, map frame
   */
  private static List<TaskOrder> orders(
      Supervision supervision,
      SupervisedBox box,
      Watch watch,
      FleetSnapshot snapshot,
      SupervisionRules rules,
      Collection<Vec2> others) {
    Vec2 place = box.place();
    if (place == null) {
      return List.of();
    }
    OccupancyGrid drivable = watch.area.among(others);
    BitSet reachable = DrivableArea.reachable(drivable, robots(supervision, snapshot));
    Predicate<Vec2> isReachable = at -> reachable.get(drivable.index(drivable.cellAt(at)));
    String name = "Box " + box.number();
    Double weight = box.weight();
    if (weight != null && rules.isForTwo(box)) {
      int cells = (int) Math.ceil(BESIDE / drivable.resolution());
      return drivable.cellsAround(place, cells).stream().map(drivable::centre).anyMatch(isReachable)
          ? List.of(order(supervision, name, weight, place, box.target(), FOR_TWO, null))
          : List.of();
    }
    Optional<Arm> arm =
        workers(supervision, snapshot).stream()
            .flatMap(robot -> Optional.ofNullable(robot.capabilities().arm()).stream())
            .findFirst();
    List<TaskOrder> orders = new ArrayList<>();
    if (arm.isPresent()) {
      ArmHandling handling = new ArmHandling(place, box.target());
      List<Vec2> goals = HandlingPlaces.round(box.target(), arm.get(), drivable);
      for (Vec2 from : HandlingPlaces.round(place, arm.get(), drivable)) {
        for (Vec2 to : isReachable.test(from) ? goals : List.<Vec2>of()) {
          orders.add(order(supervision, name, rules.threshold(), from, to, 0, handling));
        }
      }
    }
    return orders;
  }

  static List<Vec2> robots(Supervision supervision, FleetSnapshot snapshot) {
    return Stream.concat(Stream.of(supervision.supervisor()), supervision.workers().stream())
        .flatMap(name -> SupervisionRules.robot(snapshot, name).stream())
        .flatMap(robot -> Stream.ofNullable(robot.telemetry().pose()))
        .map(Pose::position)
        .toList();
  }

  private static TaskOrder order(
      Supervision supervision,
      String name,
      double load,
      Vec2 from,
      Vec2 to,
      int priority,
      @Nullable ArmHandling arm) {
    return new TaskOrder(
        name,
        load,
        new Where.Point(from),
        new Where.Point(to),
        supervision.floor(),
        priority,
        null,
        null,
        supervision.workers(),
        List.of(),
        arm);
  }

  private void command(long task, MissionEvent.OperatorCommand command) {
    await(fleet.commandTask(task, command));
  }

  /** Null: it was not answered in time. */
  private static <T> @Nullable Answer<T> await(CompletionStage<Answer<T>> asked) {
    try {
      return asked.toCompletableFuture().get(LIMIT.toMillis(), TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (ExecutionException | TimeoutException e) {
      log.warn("The fleet did not answer; it is asked again: {}", e.toString());
    }
    return null;
  }

  // --- the supervisor looks for boxes ------------------------------------------------------------

  private void search(
      Supervision now,
      Watch watch,
      RobotView robot,
      Vec2 place,
      double range,
      FleetSnapshot snapshot) {
    boolean isFree =
        robot.state().kind() == RobotState.Kind.OPERATIONAL
            && robot.work().task() == null
            && robot.work().charger() == null
            && robot.work().driver() == null
            && !robot.work().held();
    if (!isFree || watch.seen.isComplete() || !SupervisionRules.maySearch(now, snapshot)) {
      watch.view = null;
      return;
    }
    Vec2 view = watch.view;
    Instant at = fleetClock.instant();
    if (view != null && !watch.seen.isView(view, range)) {
      view = null; // what it should show was seen on the way
    } else if (view != null
        && (place.distanceTo(view) < ARRIVED || at.isAfter(watch.sentAt.plus(DRIVE_LIMIT)))) {
      watch.seen.giveUp(view);
      view = null;
    }
    if (view == null) {
      Optional<Vec2> next = watch.seen.nextView(place, range);
      watch.view = null;
      if (next.isPresent()) {
        watch.view = next.get();
        watch.sentAt = at;
        await(fleet.sendTo(robot.name(), next.get()));
      }
    } else if (robot.state() == RobotState.IDLE) {
      await(fleet.sendTo(robot.name(), view));
    }
  }

  @Override
  public void close() {
    thread.shutdown();
    try {
      if (!thread.awaitTermination(END_LIMIT.toMillis(), TimeUnit.MILLISECONDS)) {
        log.warn("The supervisor does not end.");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
