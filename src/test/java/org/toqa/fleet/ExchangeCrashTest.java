package org.toqa.fleet;

import static java.util.stream.Collectors.toMap;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.toqa.allocation.AllocationMethod;
import org.toqa.allocation.AllocationProblem;
import org.toqa.allocation.Availability;
import org.toqa.allocation.Candidate;
import org.toqa.allocation.Decision;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.mission.TaskState;
import org.toqa.wording.Sentence;

/** Two robots exchange their tasks, and the server is killed at one of its writes. */
@Timeout(120)
class ExchangeCrashTest {
  private static final int WRITES = 4;
  private static final Set<String> READS =
      Set.of("storedRobots", "pause", "floorAllocators", "openTasks", "drive", "checkAvailable");

  private static final FloorMap FLOOR =
      new FloorMap(
          "hall",
          OccupancyGrid.parse(
              "............", //
              "............",
              "............"),
          List.of(new Place("West", new Vec2(3.5, 2.5)), new Place("East", new Vec2(8.5, 2.5))),
          List.of(new Place("P1", new Vec2(0.5, 0.5)), new Place("P2", new Vec2(11.5, 0.5))),
          List.of());

  private final Allocator allocator = new Allocator();
  private Life life = new Life();

  /** A server's time until it is killed; afterwards nothing of it reaches the store. */
  private static final class Life implements TamperedStore.Between {
    private int writesToLive = Integer.MAX_VALUE;
    private boolean lastIsWritten;
    private volatile boolean over;

    synchronized void willEnd(int writes, boolean lastWritten) {
      writesToLive = writes;
      lastIsWritten = lastWritten;
    }

    @Override
    public synchronized Object call(String method, Object[] arguments, TamperedStore.Call real)
        throws Throwable {
      if (over) {
        throw new Killed();
      }
      if (READS.contains(method) || --writesToLive >= 0) {
        return real.go();
      }
      try {
        if (lastIsWritten) {
          real.go();
        }
      } finally {
        over = true; // only now, when nothing of it is running any more
      }
      throw new Killed();
    }
  }

  /**
   * No {@link org.toqa.persistence.StoreException}, after which a living server would try again.
   */
  private static final class Killed extends RuntimeException {
    private static final long serialVersionUID = 1;

    Killed() {
      super("The server was killed.", null, false, false);
    }
  }

  /** Gives each task to the next free robot, and lets two robots exchange theirs when told to. */
  private static final class Allocator implements org.toqa.allocation.Allocator {
    private volatile boolean exchanges;

    @Override
    public List<Decision> allocate(AllocationProblem situation) {
      List<Decision> decisions = new ArrayList<>();
      if (exchanges && situation.givenTasks().size() == 2) {
        AllocationProblem.GivenTask one = situation.givenTasks().getFirst();
        AllocationProblem.GivenTask other = situation.givenTasks().getLast();
        decisions.add(
            new Decision.Assigned(
                one.task().id(), List.of(other.robot()), Sentence.verbatim("exchange")));
        decisions.add(
            new Decision.Assigned(
                other.task().id(), List.of(one.robot()), Sentence.verbatim("exchange")));
      }
      Iterator<String> free =
          situation.robots().stream()
              .filter(robot -> robot.availability() == Availability.FREE)
              .map(Candidate::robot)
              .sorted()
              .iterator();
      situation
          .waiting()
          .forEach(
              job ->
                  decisions.add(
                      free.hasNext()
                          ? new Decision.Assigned(
                              job.id(), List.of(free.next()), Sentence.verbatim("next"))
                          : new Decision.Unassigned(
                              job.id(), Sentence.verbatim("no robot is free"), List.of())));
      return decisions;
    }
  }

  static Stream<Arguments> boundaries() {
    return IntStream.range(0, WRITES)
        .boxed()
        .flatMap(write -> Stream.of(Arguments.of(write, false), Arguments.of(write, true)));
  }

  /**
   * @param write the one that the server is killed at, from the beginning of the exchange
   * @param written whether it is killed after it
   */
  @ParameterizedTest
  @MethodSource("boundaries")
  void tasksAndRobotsAgreeAndAllIsDoneOnce(int write, boolean written) throws Exception {
    try (FleetStage stage =
        new FleetStage(
            FLOOR,
            ChargingRules.USUAL,
            new AllocationMethod.Computed(allocator),
            this::inANewLife)) {
      stage.add("a", new Vec2(0.5, 0.5), "P1").setStuck(true);
      stage.add("b", new Vec2(11.5, 0.5), "P2").setStuck(true);
      stage.restart();
      stage.await(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
      long first = submit(stage, "East", "West");
      stage.await(view -> isBy(view, first, "a", 1));
      long second = submit(stage, "West", "East");
      stage.await(view -> isBy(view, second, "b", 1));
      long third = submit(stage, "East", "West");

      Life ends = life;
      allocator.exchanges = true;
      ends.willEnd(write, written);
      stage.await(view -> ends.over || (isBy(view, first, "b", 1) && isBy(view, second, "a", 1)));
      allocator.exchanges = false;
      stage.scriptedRobot("a").setStuck(false);
      stage.scriptedRobot("b").setStuck(false);
      stage.await(view -> ends.over);
      assertRobotsAgreeWithTasks(stage);

      stage.restart();
      stage.await(view -> isDone(stage, first, second, third));
      for (long task : List.of(first, second, third)) {
        assertEquals(1, told(stage, task, "Picked up"), () -> "" + stage.store.history(task));
        assertEquals(1, told(stage, task, "Delivered"), () -> "" + stage.store.history(task));
      }
      assertRobotsAgreeWithTasks(stage);
    }
  }

  private FleetStore inANewLife(FleetStore store) {
    life = new Life();
    return TamperedStore.of(store, life);
  }

  private static long submit(FleetStage stage, String start, String goal) throws Exception {
    TaskOrder order =
        new TaskOrder(
            "box", 1, new Where.Station(start), new Where.Station(goal), null, 0, null, null);
    Answer<TaskView> answer =
        stage.fleet.submit(order, "Clara").toCompletableFuture().get(10, TimeUnit.SECONDS);
    return ((Answer.Accepted<TaskView>) answer).value().id();
  }

  private static boolean isBy(FleetSnapshot view, long task, String robot, int phase) {
    return view.tasks().stream().anyMatch(t -> t.id() == task && t.robots().equals(List.of(robot)))
        && view.robots().stream()
            .anyMatch(r -> r.name().equals(robot) && r.work().phase().number() == phase);
  }

  private static boolean isDone(FleetStage stage, long... tasks) {
    return LongStream.of(tasks)
        .allMatch(id -> stage.store.task(id).orElseThrow().state() == TaskState.DONE);
  }

  private static long told(FleetStage stage, long task, String beginning) {
    return stage.store.history(task).stream().filter(e -> e.text().startsWith(beginning)).count();
  }

  /**
   * What is stored of each robot follows from the tasks that are stored, and it has one at most.
   */
  private static void assertRobotsAgreeWithTasks(FleetStage stage) {
    Map<String, List<Integer>> phases = new TreeMap<>();
    stage.store.robots().forEach(r -> phases.put(r.name(), List.of()));
    stage.store.openTasks().stream()
        .flatMap(t -> t.mission().assignedRobots().stream())
        .filter(c -> !c.unassigned())
        .forEach(
            c -> phases.merge(c.robot(), List.of(c.phase().number()), ExchangeCrashTest::both));
    assertTrue(phases.values().stream().allMatch(p -> p.size() <= 1), phases::toString);
    Map<String, String> expected =
        phases.entrySet().stream().collect(toMap(Map.Entry::getKey, e -> row(e.getValue())));
    assertEquals(expected, stored(stage));
  }

  private static List<Integer> both(List<Integer> some, List<Integer> others) {
    return Stream.concat(some.stream(), others.stream()).toList();
  }

  /** Availability 1: can be given a task; phase 0: parked. */
  private static String row(List<Integer> phases) {
    int phase = phases.isEmpty() ? 0 : phases.getFirst();
    return "availability %d, phase %d".formatted(phase == 0 || phase == 3 ? 1 : 0, phase);
  }

  private static Map<String, String> stored(FleetStage stage) {
    return stage
        .database
        .jdbi()
        .withHandle(
            h ->
                h
                    .createQuery("select name, availability, phase from robots")
                    .map(
                        (rs, context) ->
                            Map.entry(
                                rs.getString("name"),
                                "availability %d, phase %d"
                                    .formatted(rs.getInt("availability"), rs.getInt("phase"))))
                    .stream()
                    .collect(toMap(Map.Entry::getKey, Map.Entry::getValue)));
  }
}
