package org.toqa.allocation;

import static java.util.Objects.requireNonNull;
import static java.util.stream.Collectors.toMap;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.toqa.allocation.Floors.NOON;
import static org.toqa.allocation.Floors.free;
import static org.toqa.allocation.Floors.job;
import static org.toqa.allocation.Floors.situation;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.toqa.geometry.Vec2;

/** Loads of 8 kg take two of these robots, the others one. */
class PlaceReservationsTest {
  private static final Vec2 PLACE = new Vec2(10, 5);

  private final List<Candidate> four =
      List.of(free("r1", 5, 1), free("r2", 5, 2), free("r3", 5, 3), free("r4", 5, 4));

  @ParameterizedTest
  @EnumSource
  void severalRobotsWaitUntilOneHasLeftTheirStart(Policy policy) {
    List<PlaceUse> inUse = List.of(new PlaceUse(7, PLACE, false));
    assertEquals(
        Map.of(
            1L,
            "It needs several robots, which need the start for themselves; task 7 is using it."),
        waiting(policy, List.of(job(1, 8, 10)), inUse));
  }

  @ParameterizedTest
  @EnumSource
  void oneRobotWaitsUntilSeveralHaveLeftItsGoal(Policy policy) {
    AllocationTask toPlace = new AllocationTask(1, 2, new Vec2(40, 5), PLACE, NOON);
    List<PlaceUse> inUse = List.of(new PlaceUse(7, PLACE, true));
    assertEquals(
        Map.of(1L, "The robots that carry the load of task 7 together are using the goal."),
        waiting(policy, List.of(toPlace), inUse));
  }

  @ParameterizedTest
  @EnumSource
  void severalRobotsNeedTheirStopsForThemselves(Policy policy) {
    List<PlaceUse> inUse = List.of(new PlaceUse(7, PLACE, false));
    AllocationTask tour =
        new AllocationTask(1, 8, new Vec2(40, 5), new Vec2(50, 5), NOON)
            .withStops(List.of(PLACE), false);
    assertEquals(
        Map.of(
            1L,
            "It needs several robots, which need the stop on the way for themselves;"
                + " task 7 is using it."),
        waiting(policy, List.of(tour), inUse));
  }

  @ParameterizedTest
  @EnumSource
  void oneRobotEachMayShareAPlace(Policy policy) {
    List<PlaceUse> inUse = List.of(new PlaceUse(7, PLACE, false));
    assertEquals(Map.of(), waiting(policy, List.of(job(1, 2, 10), job(2, 2, 10)), inUse));
  }

  /** A place of a team is 1.2 m round it; so near to it nobody else fetches or sets down. */
  @ParameterizedTest
  @EnumSource
  void aPlaceBesideThatOfATeamIsTakenUpToItsEdge(Policy policy) {
    List<PlaceUse> inUse = List.of(new PlaceUse(7, PLACE, true));
    for (double metres : new double[] {0.3, 1.19, 1.21}) {
      Vec2 beside = PLACE.plus(new Vec2(metres, 0));
      AllocationTask fromThere = new AllocationTask(1, 2, beside, new Vec2(40, 5), NOON);
      AllocationTask toThere = new AllocationTask(1, 2, new Vec2(40, 5), beside, NOON);
      int waiting = metres < 1.2 ? 1 : 0;
      assertEquals(waiting, waiting(policy, List.of(fromThere), inUse).size(), metres + " m");
      assertEquals(waiting, waiting(policy, List.of(toThere), inUse).size(), metres + " m");
    }
  }

  @ParameterizedTest
  @EnumSource
  void ofTwoTeamsForOnePlaceTheSecondWaits(Policy policy) {
    assertEquals(
        Map.of(
            2L,
            "It needs several robots, which need the start for themselves; task 1 is using it."),
        waiting(policy, List.of(job(1, 8, 10), job(2, 8, 10)), List.of()));
  }

  @ParameterizedTest
  @EnumSource
  void whoWaitsForAPlaceGoesBeforeLaterOnes(Policy policy) {
    List<PlaceUse> inUse = List.of(new PlaceUse(7, PLACE, false));
    Map<Long, String> waiting =
        waiting(policy, List.of(job(1, 8, 10), job(2, 2, 10), job(3, 2, 60)), inUse);
    assertEquals("Task 1 comes first at the start.", waiting.get(2L));
    assertEquals(2, waiting.size());
  }

  /** As many rounds as it takes; what was given out ends in any order. */
  @ParameterizedTest
  @EnumSource
  void everythingIsGivenOutAndNoTeamSharesAPlace(Policy policy) {
    for (int seed = 0; seed < 40; seed++) {
      Random random = new Random(seed);
      List<AllocationTask> queue = new ArrayList<>();
      for (int i = 0; i < 30; i++) {
        double load = random.nextInt(3) == 0 ? 8 + 8 * random.nextInt(2) : 2;
        queue.add(
            new AllocationTask(i, load, station(random), station(random), NOON.plusSeconds(i)));
      }
      Rounds rounds = new Rounds(policy, queue, random);
      for (int round = 0; round < 200 && !rounds.queue.isEmpty(); round++) {
        rounds.next();
      }
      assertEquals(List.of(), rounds.queue, "seed " + seed);
    }
  }

  private static Vec2 station(Random random) {
    return new Vec2(10 + 10 * random.nextInt(5), 5);
  }

  private final class Rounds {
    private final Allocator allocator;
    private final List<AllocationTask> queue;
    private final Random random;
    private final Map<AllocationTask, List<String>> active = new HashMap<>();

    Rounds(Policy policy, List<AllocationTask> queue, Random random) {
      this.allocator = NegotiatedAllocator.of(policy);
      this.queue = queue;
      this.random = random;
    }

    void next() {
      List<Candidate> robots = four.stream().map(this::asItIs).toList();
      List<PlaceUse> inUse =
          active.keySet().stream().flatMap(task -> usesOf(task).stream()).toList();
      Map<Long, AllocationTask> byId =
          queue.stream().collect(toMap(AllocationTask::id, task -> task));
      for (Decision decision :
          allocator.allocate(situation(NOON.plusSeconds(100), queue, List.of(), robots, inUse))) {
        if (decision instanceof Decision.Assigned(long id, List<String> chosen, var _)) {
          AllocationTask task = requireNonNull(byId.get(id));
          active.keySet().forEach(other -> assertApart(task, other));
          active.put(task, chosen);
          queue.remove(task);
        }
      }
      assertTrue(!active.isEmpty() || queue.isEmpty(), "nobody is given anything");
      active.keySet().removeIf(task -> random.nextInt(3) == 0);
    }

    private Candidate asItIs(Candidate robot) {
      return active.entrySet().stream()
          .filter(e -> e.getValue().contains(robot.robot()))
          .findFirst()
          .map(e -> robot.withTask(e.getKey().id()))
          .orElse(robot);
    }

    private List<PlaceUse> usesOf(AllocationTask task) {
      return List.of(
          new PlaceUse(task.id(), task.start(), task.load() > 5),
          new PlaceUse(task.id(), task.goal(), task.load() > 5));
    }

    private void assertApart(AllocationTask task, AllocationTask other) {
      if (task.load() > 5 || other.load() > 5) {
        for (PlaceUse one : usesOf(task)) {
          usesOf(other).forEach(two -> assertTrue(one.place().distanceTo(two.place()) > 1));
        }
      }
    }
  }

  /** By task. */
  private Map<Long, String> waiting(
      Policy policy, List<AllocationTask> tasks, List<PlaceUse> inUse) {
    return NegotiatedAllocator.of(policy)
        .allocate(situation(NOON, tasks, List.of(), four, inUse))
        .stream()
        .filter(Decision.Unassigned.class::isInstance)
        .collect(toMap(Decision::task, d -> d.reason().english()));
  }
}
