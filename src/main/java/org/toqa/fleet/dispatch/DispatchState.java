package org.toqa.fleet.dispatch;

import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.apache.pekko.actor.typed.ActorRef;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.Candidate;
import org.toqa.allocation.PlaceUse;
import org.toqa.fleet.FleetRuntime;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.FloorView.LeftLoad;
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
import org.toqa.mission.TaskState;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * The floor's tasks as they are now, which the parts of its dispatch share. Confined to its agent.
 */
final class DispatchState {
  private static final int ENDED_SHOWN = 50;

  /** So many of the queue's first tasks are looked at. */
  static final int TASKS_CONSIDERED = 200;

  static final Sentence LOOKING_FOR_ROBOT = Phrase.LOOKING_FOR_ROBOT.with();

  final FloorMap floor;
  final FloorDistances distances;
  final ActorRef<FloorMessage> floorAgent;
  final FleetStore store;
  final StoreWriter writer;
  final InstantSource clock;
  final FleetRuntime runtime;
  final TaskQueue queue = new TaskQueue();
  final OrderLegs legs = new OrderLegs();
  final Map<String, RobotRecord> robots = new TreeMap<>();

  /** What the floor has told last; null: nothing yet. */
  FloorEvent.@Nullable FloorReport report;

  /** Tasks that were handed to the floor, which has not answered yet. */
  final Map<Long, TaskView> handedOver = new HashMap<>();

  final Deque<TaskView> ended = new ArrayDeque<>();

  /** Whether robots or tasks have changed since the last round of allocation began. */
  boolean isRoundDue = true;

  /** Of the time that ticks bring, by which waits are measured. */
  Instant now;

  /** Whether there is something new to show. */
  boolean changed = true;

  private final TaskFloors taskFloors;

  /**
   * @param taskFloors is told which tasks are here
   */
  DispatchState(
      FloorMap floor,
      ActorRef<FloorMessage> floorAgent,
      TaskFloors taskFloors,
      FleetStore store,
      InstantSource clock,
      Instant now,
      FleetRuntime runtime,
      Consumer<Sentence> onLeftOut) {
    this.floor = floor;
    this.distances = new FloorDistances(floor.grid());
    this.floorAgent = floorAgent;
    this.taskFloors = taskFloors;
    this.store = store;
    this.writer =
        new StoreWriter("tasks-" + floor.name(), runtime, store::inOneTransaction, onLeftOut);
    this.clock = clock;
    this.runtime = runtime;
    this.now = now;
  }

  void setReport(FloorEvent.FloorReport now) {
    report = now;
    setLeftLoads(now.floor().leftLoads().stream().map(LeftLoad::task));
  }

  void setLeftLoads(Stream<Long> tasks) {
    taskFloors.setLeftLoads(floor.name(), tasks.collect(Collectors.toUnmodifiableSet()));
  }

  void addEnded(TaskView task) {
    recordLeg(task);
    taskFloors.removeOpen(task.id());
    ended.removeIf(before -> before.id() == task.id());
    ended.addFirst(task);
    if (ended.size() > ENDED_SHOWN) {
      ended.removeLast();
    }
  }

  /** It is time to look at the legs of its order when one is delivered. */
  void recordLeg(TaskView task) {
    isRoundDue |= legs.record(task);
  }

  /** Puts a task that is stored so into the queue. */
  void enqueue(Mission mission, Instant since) {
    queue.add(mission, since, true);
    taskFloors.addOpen(mission.id(), floor.name());
    legs.record(mission);
    isRoundDue = true;
  }

  /** As it was stored when this began. */
  void recover(Mission mission, Instant since) {
    taskFloors.addOpen(mission.id(), floor.name());
    if (mission.state() == TaskState.QUEUED) {
      queue.add(mission, since, true);
    }
  }

  /** Whether nothing moves or waits here: the floor has neither robots nor tasks. */
  boolean isIdle() {
    return robots.isEmpty()
        && robotsHere().isEmpty()
        && queue.size() == 0
        && handedOver.isEmpty()
        && assignedTasks().isEmpty();
  }

  /** Whether a task of that order has not ended. */
  boolean isOrderOpen(long order) {
    return Stream.concat(
            queue.tasks(),
            Stream.concat(handedOver.values().stream(), assignedTasks().stream())
                .map(TaskView::task))
        .anyMatch(task -> task.part() != null && task.part().order() == order);
  }

  /**
   * What all robots carry together, kilograms: no more than each says and than a person entered. A
   * robot that was never connected does not count, once another was.
   */
  private double totalCapacity() {
    if (robots.isEmpty()) {
      return Double.MAX_VALUE;
    }
    Map<String, Double> known =
        robotsHere().stream()
            .filter(RobotView::isLoadKnown)
            .collect(Collectors.toMap(RobotView::name, RobotView::maxLoad));
    return robots.values().stream()
        .mapToDouble(r -> known.getOrDefault(r.name(), known.isEmpty() ? r.maxLoad() : 0))
        .sum();
  }

  Capacity capacity() {
    Map<String, Double> maxLoads =
        robots.values().stream().collect(Collectors.toMap(RobotRecord::name, RobotRecord::maxLoad));
    robotsHere().stream()
        .filter(RobotView::isLoadKnown)
        .forEach(robot -> maxLoads.computeIfPresent(robot.name(), (_, _) -> robot.maxLoad()));
    return new Capacity(totalCapacity(), candidates(), maxLoads, robotsHere());
  }

  /** Whether the floor's agent has the task: it has robots, or its load lies there. */
  boolean isOnFloor(long task) {
    return Stream.concat(handedOver.values().stream(), assignedTasks().stream())
            .anyMatch(t -> t.id() == task)
        || hasLoadOf(task);
  }

  /** Whether the load of that ended task lies on the floor. */
  boolean hasLoadOf(long task) {
    return taskFloors.hasLeftLoad(floor.name(), task);
  }

  List<RobotView> robotsHere() {
    FloorEvent.FloorReport told = report;
    return told == null ? List.of() : told.robots();
  }

  List<TaskView> assignedTasks() {
    FloorEvent.FloorReport told = report;
    return told == null ? List.of() : told.missions();
  }

  /** Who is meant where a task allows some robots alone. */
  ChosenRobots chosen() {
    return new ChosenRobots(robotsHere());
  }

  List<Candidate> candidates() {
    Set<String> promised =
        handedOver.values().stream().flatMap(t -> t.robots().stream()).collect(Collectors.toSet());
    return Candidates.of(floor, robotsHere(), promised);
  }

  List<PlaceUse> placesInUse() {
    Map<Long, TaskView> begun = new TreeMap<>(handedOver);
    assignedTasks().forEach(t -> begun.put(t.id(), t));
    return PlacesInUse.of(begun.values().stream(), robotsHere());
  }

  List<Vec2> chargerPositions() {
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
}
