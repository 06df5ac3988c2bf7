package org.toqa.allocation;

import static java.util.Objects.requireNonNull;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.toqa.allocation.Floors.NOON;
import static org.toqa.allocation.Floors.busy;
import static org.toqa.allocation.Floors.free;
import static org.toqa.allocation.Floors.job;
import static org.toqa.allocation.Floors.robot;
import static org.toqa.allocation.Floors.situation;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.toqa.geometry.Vec2;
import org.toqa.wording.Sentence;

/** What every allocator holds to. */
class AllocatorContractTest {
  private static final int SEEDS = 200;

  static Stream<Allocator> allocators() {
    return Stream.of(
        new NearestFreeRobot(),
        new ZoneAllocator(),
        new NegotiatedAllocator(),
        new OptimalAllocator());
  }

  @ParameterizedTest
  @MethodSource("allocators")
  void everyTaskIsDecidedOnceAndARobotGetsAtMostOneThatItCanCarry(Allocator allocator) {
    for (int seed = 0; seed < SEEDS; seed++) {
      AllocationProblem problem = Floors.random(seed, 1 + seed % 12, 1 + seed % 9, 0);
      Map<String, Candidate> robots = new HashMap<>();
      problem.robots().forEach(r -> robots.put(r.robot(), r));
      Set<String> chosen = new HashSet<>();
      List<Decision> decisions = allocator.allocate(problem);

      assertEquals(
          problem.waiting().stream().map(AllocationTask::id).sorted().toList(),
          decisions.stream().map(Decision::task).sorted().toList(),
          "seed " + seed);
      for (Decision decision : decisions) {
        assertFalse(decision.reason().english().isBlank());
        for (String name : Outcome.robots(decision)) {
          Candidate robot = requireNonNull(robots.get(name));
          assertTrue(chosen.add(name), "seed " + seed + ": " + name + " has two tasks");
          assertTrue(robot.isFree(), "seed " + seed + ": " + name);
          assertTrue(
              Outcome.robots(decision).size() > 1
                  || robot.isStrongEnough(byId(problem, decision.task())),
              "seed " + seed + ": " + name);
        }
      }
    }
  }

  @ParameterizedTest
  @MethodSource("allocators")
  void noTaskWaitsWhileARobotThatCanCarryItIsLeft(Allocator allocator) {
    for (int seed = 0; seed < SEEDS; seed++) {
      AllocationProblem problem = Floors.random(seed, 1 + seed % 7, 1 + seed % 9, 0);
      List<Decision> decisions = allocator.allocate(problem);
      Set<String> chosen = new HashSet<>();
      decisions.forEach(d -> chosen.addAll(Outcome.robots(d)));
      if (problem.waiting().stream().anyMatch(t -> TeamSize.isForSeveral(problem, t))) {
        continue; // robots may be kept for it
      }
      for (Decision decision : decisions) {
        AllocationTask task = byId(problem, decision.task());
        assertTrue(
            decision instanceof Decision.Assigned
                || problem.freeRobots().stream()
                    .noneMatch(r -> r.isStrongEnough(task) && !chosen.contains(r.robot())),
            "seed " + seed + ", task " + task.id());
      }
    }
  }

  @ParameterizedTest
  @MethodSource("allocators")
  void tasksGivenOutStayWithSomebodyAndNobodyGetsTwo(Allocator allocator) {
    for (int seed = 0; seed < SEEDS; seed++) {
      AllocationProblem problem = Floors.random(seed, 1 + seed % 7, 4 + seed % 9, 3);
      List<Decision> decisions = allocator.allocate(problem);
      for (Decision decision : decisions) {
        assertTrue(
            decision instanceof Decision.Assigned || decision.task() < 1000,
            "seed " + seed + ": a task given out waits again");
      }
      Map<Long, String> holders = new Outcome(problem, decisions).holders;
      assertEquals(
          holders.size(), new HashSet<>(holders.values()).size(), "seed " + seed + holders);
    }
  }

  @ParameterizedTest
  @MethodSource("allocators")
  void aTaskForCertainRobotsGoesToNoOthers(Allocator allocator) {
    int given = 0;
    for (int seed = 0; seed < SEEDS; seed++) {
      AllocationProblem problem = withChoices(Floors.random(seed, 1 + seed % 12, 4 + seed % 9, 3));
      for (Decision decision : allocator.allocate(problem)) {
        AllocationTask task =
            Stream.concat(
                    problem.waiting().stream(),
                    problem.givenTasks().stream().map(AllocationProblem.GivenTask::task))
                .filter(t -> t.id() == decision.task())
                .findFirst()
                .orElseThrow();
        for (String robot : Outcome.robots(decision)) {
          assertTrue(task.allows(robot), "seed " + seed + ": " + robot + " " + task);
          given += task.onlyRobots().isEmpty() ? 0 : 1;
        }
      }
    }
    assertTrue(given > SEEDS, "given to a chosen robot: " + given);
  }

  /** Most tasks may be had by some robots only; who has one may have it. */
  private static AllocationProblem withChoices(AllocationProblem problem) {
    List<String> names = problem.robots().stream().map(Candidate::robot).toList();
    return new AllocationProblem(
        problem.now(),
        problem.low(),
        problem.high(),
        problem.terrain(),
        problem.waiting().stream()
            .map(task -> task.withOnlyRobots(chosen(names, task.id())))
            .toList(),
        problem.givenTasks().stream()
            .map(
                held ->
                    new AllocationProblem.GivenTask(
                        held.task()
                            .withOnlyRobots(
                                List.of(
                                    held.robot(),
                                    names.get((int) held.task().id() % names.size()))),
                        held.robot()))
            .toList(),
        problem.robots(),
        problem.placesInUse());
  }

  private static List<String> chosen(List<String> names, long task) {
    return task % 4 == 0
        ? List.of()
        : names.stream().filter(name -> (name.hashCode() + task) % 3 != 0).toList();
  }

  @ParameterizedTest
  @MethodSource("allocators")
  void aTaskIsServedInTheEndThoughNearerAndMoreUrgentOnesKeepComing(Allocator allocator) {
    AllocationTask far = new AllocationTask(0, 4, new Vec2(79, 5), new Vec2(79, 6), NOON);
    List<AllocationTask> waiting = new ArrayList<>(List.of(far));
    Instant now = NOON;
    for (int id = 1; id <= 200 && waiting.contains(far); id++) {
      now = now.plusSeconds(30);
      Instant since = AllocationTask.waitingSince(now, 10, null);
      waiting.add(new AllocationTask(id, 1, new Vec2(1, 5), new Vec2(1, 6), since));
      for (Decision decision :
          allocator.allocate(situation(now, waiting, List.of(), List.of(free("r1", 5, 0))))) {
        if (decision instanceof Decision.Assigned) {
          waiting.removeIf(j -> j.id() == decision.task());
        }
      }
    }
    assertFalse(waiting.contains(far), "it waits still after " + Duration.between(NOON, now));
  }

  @ParameterizedTest
  @MethodSource("allocators")
  void aRobotWithoutAWayToTheLoadIsLeftOut(Allocator allocator) {
    PathLengths walled =
        (place, diameter) ->
            other -> (place.x() < 40) == (other.x() < 40) ? 1 : Double.POSITIVE_INFINITY;
    AllocationProblem problem =
        new AllocationProblem(
            NOON,
            Vec2.ZERO,
            new Vec2(80, 10),
            new Terrain(walled, List.of()),
            List.of(job(1, 1, 60)),
            List.of(),
            List.of(free("r1", 5, 20), free("r2", 5, 39)),
            List.of());

    assertEquals(
        List.of(
            new Decision.Unassigned(
                1,
                Sentence.verbatim(
                    "None of the 2 robots that are strong enough can take it now:"
                        + " r1 finds no path to the load and its goal that is wide enough for"
                        + " 0.26 m,"
                        + " r2 finds no path to the load and its goal that is wide enough for"
                        + " 0.26 m."),
                List.of())),
        Outcome.inEnglish(allocator.allocate(problem)));
  }

  @ParameterizedTest
  @MethodSource("allocators")
  void aRobotThatIsTooWideForTheWayIsNotChosen(Allocator allocator) {
    Candidate wide = sized("wide", 0.6, 0.25, 39);
    Candidate narrow = sized("narrow", 0.25, 0.25, 20);

    assertEquals(List.of("narrow"), chosen(allocator, List.of(wide, narrow)));
    assertEquals(
        List.of(
            new Decision.Unassigned(
                1,
                Sentence.verbatim(
                    "The only robot, wide, finds no path to the load and its goal that is wide enough"
                        + " for 0.60 m."),
                List.of())),
        Outcome.inEnglish(allocator.allocate(throughADoor(List.of(wide)))));
  }

  @Test
  void ofRobotsAsFarTheFasterOneIsChosen() {
    Candidate slow = sized("slow", 0.25, 0.1, 39);
    Candidate fast = sized("fast", 0.25, 0.25, 38);
    for (Allocator allocator : List.of(new NegotiatedAllocator(), new OptimalAllocator())) {
      assertEquals(List.of("fast"), chosen(allocator, List.of(slow, fast)));
    }
  }

  @ParameterizedTest
  @EnumSource
  void whereTheStrongRobotIsTooWideTheOthersCarryTogether(Policy policy) {
    Candidate wide = sized("wide", 0.6, 0.25, 39);
    List<Candidate> robots =
        List.of(
            new Candidate(
                "strong",
                50,
                0.6,
                0.25,
                true,
                wide.position(),
                wide.parking(),
                1.0,
                Availability.FREE,
                null),
            sized("a", 0.25, 0.25, 20),
            sized("b", 0.25, 0.25, 21));
    AllocationProblem problem =
        throughADoor(robots, new AllocationTask(1, 8, new Vec2(40, 5), new Vec2(50, 5), NOON));

    assertEquals(
        List.of("b", "a"),
        Outcome.robots(NegotiatedAllocator.of(policy).allocate(problem).getFirst()));
  }

  private static List<String> chosen(Allocator allocator, List<Candidate> robots) {
    return Outcome.robots(allocator.allocate(throughADoor(robots)).getFirst());
  }

  private static AllocationProblem throughADoor(List<Candidate> robots) {
    return throughADoor(robots, new AllocationTask(1, 1, new Vec2(40, 5), new Vec2(50, 5), NOON));
  }

  /** The goal lies behind a doorway of half a metre. */
  private static AllocationProblem throughADoor(List<Candidate> robots, AllocationTask task) {
    PathLengths doorway =
        (place, diameter) ->
            other ->
                diameter > 0.5 && (place.x() < 45) != (other.x() < 45)
                    ? Double.POSITIVE_INFINITY
                    : place.distanceTo(other);
    return new AllocationProblem(
        NOON,
        Vec2.ZERO,
        new Vec2(80, 10),
        new Terrain(doorway, List.of()),
        List.of(task),
        List.of(),
        robots,
        List.of());
  }

  private static Candidate sized(String name, double diameter, double speed, double x) {
    Vec2 place = new Vec2(x, 5);
    return new Candidate(
        name, 5, diameter, speed, true, place, place, 1.0, Availability.FREE, null);
  }

  @ParameterizedTest
  @MethodSource("allocators")
  void noRobotTakesATaskAfterWhichItWouldNotGetToACharger(Allocator allocator) {
    // 40 m to the load, 1 m with 1 kg, 39 m to the charger: 80 * 88.8 J + 1.5 J of 106,560 J = 6.7
    // %,
    // and 5 % are kept in reserve
    assertEquals(
        List.of(
            new Decision.Unassigned(
                1,
                Sentence.verbatim(
                    "The only robot, r1, has 11 % and would not reach a charger afterwards."),
                List.of("r1"))),
        Outcome.inEnglish(allocator.allocate(withChargerAtTheOtherEnd(0.11))));
    assertInstanceOf(
        Decision.Assigned.class, allocator.allocate(withChargerAtTheOtherEnd(0.12)).getFirst());
  }

  private static AllocationProblem withChargerAtTheOtherEnd(double battery) {
    Vec2 place = new Vec2(0, 5);
    return new AllocationProblem(
        NOON,
        Vec2.ZERO,
        new Vec2(80, 10),
        new Terrain(PathLengths.STRAIGHT, List.of(new Vec2(79, 6))),
        List.of(job(1, 1, 40)),
        List.of(),
        List.of(
            new Candidate(
                "r1", 5, 0.255, 0.25, true, place, place, battery, Availability.FREE, null)),
        List.of());
  }

  @ParameterizedTest
  @MethodSource("allocators")
  void whatKeepsTheOnlyStrongRobotIsSaid(Allocator allocator) {
    Map<Availability, String> sentences =
        Map.of(
            Availability.OUT_OF_SERVICE, "is out of service",
            Availability.CHARGING, "must charge first",
            Availability.LOST, "is lost",
            Availability.HELD, "is on hold",
            Availability.BUSY, "is working on task 7");
    sentences.forEach(
        (standing, words) ->
            assertEquals(
                "The only robot that is strong enough, r1, " + words + ".",
                why(
                    allocator,
                    4,
                    robot("r1", 5, 10, standing, standing == Availability.BUSY ? 7L : null),
                    free("weak", 3, 10))));
  }

  @ParameterizedTest
  @MethodSource("allocators")
  void aLoadTooHeavyForOneSaysHowManyItNeeds(Allocator allocator) {
    Candidate[] robots = {free("r1", 5, 1), busy("r2", 3, 2, 7), free("r3", 4, 3)};
    // 5 + 4 kg are enough for 9 kg, and r1 and r3 are free; 5 + 4 + 3 kg for 10 kg
    assertEquals("It needs 3 robots together; 2 of 3 are free.", why(allocator, 10, robots));
    assertEquals(
        "The load weighs 12.5 kg; all 3 robots together can carry 12 kg.",
        why(allocator, 12.5, robots));
    assertEquals("No robots have been added yet.", why(allocator, 1));
  }

  @ParameterizedTest
  @MethodSource("allocators")
  void ofManyRobotsThoseThatAreKeptAreCounted(Allocator allocator) {
    Candidate[] robots = {
      busy("r1", 5, 1, 7),
      busy("r2", 5, 2, 8),
      robot("r3", 5, 3, Availability.LOST, null),
      robot("r4", 5, 3, Availability.OUT_OF_SERVICE, null)
    };
    String kept = ": 2 are working on other tasks, 1 is out of service, 1 is lost.";
    assertEquals(
        "None of the 4 robots that are strong enough can take it now" + kept,
        why(allocator, 1, robots));
    assertEquals(
        "None of the 4 robots that may drive there can go now" + kept, why(allocator, 0, robots));
  }

  /** What the only task waits for. */
  private static String why(Allocator allocator, double load, Candidate... robots) {
    List<Decision> decisions =
        allocator.allocate(situation(List.of(job(1, load, 5)), List.of(robots)));
    assertEquals(
        List.of(new Decision.Unassigned(1, decisions.getFirst().reason(), List.of())), decisions);
    return decisions.getFirst().reason().english();
  }

  private static AllocationTask byId(AllocationProblem problem, long id) {
    return problem.waiting().stream().filter(j -> j.id() == id).findFirst().orElseThrow();
  }
}
