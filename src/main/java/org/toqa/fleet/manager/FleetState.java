package org.toqa.fleet.manager;

import static java.util.Objects.requireNonNull;

import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.apache.pekko.actor.typed.ActorRef;
import org.toqa.allocation.Candidate;
import org.toqa.allocation.PlaceUse;
import org.toqa.fleet.FleetRuntime;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.StoreWriter;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.floor.FloorDistances;
import org.toqa.fleet.floor.FloorEvent;
import org.toqa.fleet.floor.FloorMessage;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;
import org.toqa.mission.Mission;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** The fleet as it is now, which the parts of its manager share. Confined to that agent. */
final class FleetState {
  private static final int ENDED_SHOWN = 50;

  /** So many of the queue's first tasks are looked at. */
  static final int TASKS_CONSIDERED = 200;

  static final Sentence LOOKING_FOR_ROBOT = Phrase.LOOKING_FOR_ROBOT.with();

  final FleetStore store;
  final StoreWriter writer;
  final InstantSource clock;
  final FleetRuntime runtime;
  final Map<String, ActorRef<FloorMessage>> floors = new LinkedHashMap<>();
  final Map<String, FloorMap> floorMaps = new HashMap<>();
  final Map<String, FloorDistances> distances = new HashMap<>();
  final TaskQueue queue = new TaskQueue();
  final OrderLegs legs = new OrderLegs();
  final Map<String, RobotRecord> robots = new TreeMap<>();
  final Map<String, FloorEvent.FloorReport> reports = new HashMap<>();

  /** Tasks that were handed to their floors, which have not answered yet. */
  final Map<Long, TaskView> handedOver = new HashMap<>();

  /** Floors that the store knows and no map is named as, with what is said of each. */
  final Map<String, Sentence> missingFloors = new TreeMap<>();

  final Deque<TaskView> ended = new ArrayDeque<>();

  /** Floors whose robots or tasks have changed since their last round of allocation began. */
  final Set<String> dueFloors = new HashSet<>();

  /** Of the time that ticks bring, by which waits are measured. */
  Instant now;

  /** Whether there is something new to show. */
  boolean changed = true;

  FleetState(
      FleetStore store,
      InstantSource clock,
      Instant now,
      FleetRuntime runtime,
      Consumer<Sentence> onLeftOut) {
    this.store = store;
    this.writer = new StoreWriter("manager", runtime, store::inOneTransaction, onLeftOut);
    this.clock = clock;
    this.runtime = runtime;
    this.now = now;
  }

  void addEnded(TaskView task) {
    recordLeg(task);
    ended.removeIf(before -> before.id() == task.id());
    ended.addFirst(task);
    if (ended.size() > ENDED_SHOWN) {
      ended.removeLast();
    }
  }

  /** It is time to look at the legs of its order when one is delivered. */
  void recordLeg(TaskView task) {
    if (legs.record(task)) {
      dueFloors.add(task.task().floor());
    }
  }

  /** Puts a task that is stored so into the queue. */
  void enqueue(Mission mission, Instant since) {
    queue.add(mission, since, true);
    legs.record(mission);
    dueFloors.add(mission.task().floor());
  }

  /** Whether a task of that order has not ended. */
  boolean isOrderOpen(long order) {
    return Stream.concat(
            queue.tasks(),
            Stream.concat(
                    handedOver.values().stream(),
                    reports.values().stream().flatMap(report -> report.missions().stream()))
                .map(TaskView::task))
        .anyMatch(task -> task.part() != null && task.part().order() == order);
  }

  /**
   * What all robots carry together, kilograms: no more than each says and than a person entered. A
   * robot that was never connected does not count, once another was.
   */
  double totalCapacity() {
    if (robots.isEmpty()) {
      return Double.MAX_VALUE;
    }
    Map<String, Double> known =
        reports.values().stream()
            .flatMap(report -> report.robots().stream())
            .filter(RobotView::isLoadKnown)
            .collect(Collectors.toMap(RobotView::name, RobotView::maxLoad));
    return robots.values().stream()
        .mapToDouble(r -> known.getOrDefault(r.name(), known.isEmpty() ? r.maxLoad() : 0))
        .sum();
  }

  Capacity capacity() {
    return new Capacity(
        totalCapacity(),
        floorMaps.keySet().stream().collect(Collectors.toMap(floor -> floor, this::candidates)));
  }

  /** The floor whose agent has the task: it has robots, or its load lies there. */
  Optional<String> floorOf(long task) {
    return Stream.concat(
            handedOver.values().stream(),
            reports.values().stream().flatMap(r -> r.missions().stream()))
        .filter(t -> t.id() == task)
        .findFirst()
        .map(t -> t.task().floor())
        .or(() -> floorWithLoadOf(task));
  }

  Optional<String> floorWithLoadOf(long task) {
    return reports.values().stream()
        .map(FloorEvent.FloorReport::floor)
        .filter(floor -> floor.leftLoads().stream().anyMatch(load -> load.task() == task))
        .map(FloorView::name)
        .findFirst();
  }

  List<RobotView> robotsOn(String floor) {
    FloorEvent.FloorReport report = reports.get(floor);
    return report == null ? List.of() : report.robots();
  }

  List<TaskView> assignedTasks(String floor) {
    FloorEvent.FloorReport report = reports.get(floor);
    return report == null ? List.of() : report.missions();
  }

  List<Candidate> candidates(String floor) {
    FloorEvent.FloorReport report = reports.get(floor);
    if (report == null) {
      return List.of();
    }
    Set<String> promised =
        handedOver.values().stream().flatMap(t -> t.robots().stream()).collect(Collectors.toSet());
    return Candidates.of(requireNonNull(floorMaps.get(floor)), report.robots(), promised);
  }

  List<PlaceUse> placesInUse(String floor) {
    Map<Long, TaskView> begun = new TreeMap<>();
    handedOver.values().stream()
        .filter(t -> t.task().floor().equals(floor))
        .forEach(t -> begun.put(t.id(), t));
    assignedTasks(floor).forEach(t -> begun.put(t.id(), t));
    return PlacesInUse.of(begun.values().stream(), robotsOn(floor));
  }

  static List<Vec2> chargerPositions(FloorMap floor) {
    return floor.charging().stream().map(Place::position).toList();
  }

  TaskView view(long queued, Sentence why) {
    TaskQueue.Queued task = queue.get(queued).orElseThrow();
    return view(task, legs.reasonToWait(task.task()).orElse(why));
  }

  static TaskView view(TaskQueue.Queued queued, Sentence why) {
    Mission mission = queued.mission();
    return TaskView.of(mission, mission.held() ? Phrase.ON_HOLD.with() : why, queued.since());
  }

  Optional<ActorRef<FloorMessage>> floorAgent(String name) {
    return Optional.ofNullable(floors.get(name));
  }
}
