package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import net.jqwik.api.constraints.LongRange;
import net.jqwik.api.lifecycle.AfterProperty;
import org.toqa.formation.GroupMobility;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.FloorReader;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.testbed.Cases;

/** Robots that carry a load of 0.3 m together on the shipped floor. */
@Tag("full")
class FormationFootprintPropertyTest {
  private static final double LOAD = 0.3;

  /** Metres; tasks come to the places of others in turn. */
  private static final double APART = 1.2;

  /** As far as a leader is off its path when it is stopped: metres and radians. */
  private static final double BESIDE = 0.02;

  private static final double ASKEW = 0.02;

  private static final Duration LIMIT = Duration.ofMinutes(20);

  /** So that the same carry is not planned again and again. */
  private static final Map<List<Object>, Boolean> POSSIBLE = new ConcurrentHashMap<>();

  private final FloorMap lab;
  private final Cases carries = new Cases("possible carries");
  private final AtomicInteger stopped = new AtomicInteger();
  private final AtomicInteger stuck = new AtomicInteger();

  FormationFootprintPropertyTest() throws IOException {
    lab = FloorReader.read(Path.of("maps", "lab.yaml"));
  }

  /** Held at any moment, a group has a path on from where it has stopped. */
  @Property(tries = 5, seed = "20261121")
  void groupThatIsHeldOnItsWayGoesOn(@ForAll @LongRange(min = 0) long seed) {
    Random random = new Random(seed);
    Carry carry = carry(random);
    DrivenFloor floor = new DrivenFloor(lab.grid(), seed);
    carry.begin(floor, "group");
    for (int i = 0; i < 8 && !floor.areAllArrived(); i++) {
      floor.drive(Duration.ofMillis(random.nextInt(8000)));
      floor.lose("group"); // nothing more can be told to it
      floor.drive(Duration.ofSeconds(20));
      floor.find("group");
    }
    floor.drive(LIMIT);
    assertTrue(floor.areAllArrived(), () -> carry + " " + floor.reasons());
  }

  /**
   * Stopped anywhere on its way, even in a bend, and a little beside it, it goes on; of a hundred
   * that are put aside so eight times, a few come to stand where they have no room to turn.
   */
  @Property(tries = 8, seed = "20261121")
  void groupThatIsStoppedBesideItsPathGoesOn(@ForAll @LongRange(min = 0) long seed) {
    Random random = new Random(seed);
    // three have no room to correct, nor have those that need shifts
    Carry carry =
        carry(random, some -> some.robots() == 2 && some.isPossible(GroupMobility.FORWARD));
    DrivenFloor floor = new DrivenFloor(lab.grid(), seed);
    carry.begin(floor, "group");
    boolean goesOn = true;
    for (int i = 0; i < 8 && goesOn && !floor.areAllArrived(); i++) {
      floor.drive(Duration.ofMillis(random.nextInt(8000)));
      floor.stopBesidePath("group", BESIDE, ASKEW);
      floor.drive(Duration.ofSeconds(2));
      goesOn = floor.areAllArrived() || floor.body("group").trajectory != null;
    }
    stopped.incrementAndGet();
    if (goesOn) {
      floor.drive(LIMIT);
      assertTrue(floor.areAllArrived(), () -> carry + " " + floor.reasons());
    } else {
      stuck.incrementAndGet();
    }
  }

  @AfterProperty
  void nearlyAllThatWereStoppedWentOn() {
    assertTrue(stuck.get() <= 0.05 * stopped.get(), () -> stuck + " of " + stopped + " are stuck");
  }

  /** Among robots that drive to and fro, but not to its own places, it arrives, and so do they. */
  @Property(tries = 5, seed = "20261121")
  void groupArrivesAmongOthers(@ForAll @LongRange(min = 0) long seed) {
    Random random = new Random(seed);
    Carry carry = carry(random);
    DrivenFloor floor = new DrivenFloor(lab.grid(), seed);
    carry.begin(floor, "group");
    List<Vec2> places = placesBeside(carry);
    Collections.shuffle(places, random);
    int others = Math.min(1 + random.nextInt(6), places.size());
    for (int i = 0; i < others; i++) {
      floor.putAt("r" + i, places.get(i), DrivenFloor.DIAMETER);
    }
    Instant limit = floor.now.plus(LIMIT);
    while (!floor.isArrived("group") && floor.now.isBefore(limit)) {
      for (int i = 0; i < others; i++) {
        if (floor.isArrived("r" + i) && random.nextInt(100) == 0) {
          boolean isIdle = random.nextInt(4) == 0;
          floor.sendTo("r" + i, isIdle ? null : places.get(random.nextInt(places.size())));
        }
      }
      floor.step();
    }
    assertTrue(floor.isArrived("group"), () -> carry + " " + floor.reasons());
    for (int i = 0; i < others; i++) {
      floor.sendTo("r" + i, places.get(i));
    }
    floor.drive(LIMIT);
    assertTrue(floor.areAllArrived(), () -> floor.reasons().toString());
  }

  /** Two groups, neither of which ever stands in the other's only path, each arrive. */
  @Property(tries = 3, seed = "20261121")
  void twoGroupsArrive(@ForAll @LongRange(min = 0) long seed) {
    Random random = new Random(seed);
    Carry one = carry(random);
    Carry two = carry(random, other -> !other.isNear(one) && other.goesWith(one));
    DrivenFloor floor = new DrivenFloor(lab.grid(), seed);
    one.begin(floor, "one");
    two.begin(floor, "two");
    floor.drive(LIMIT);
    String both = one + " " + two + " ";
    assertTrue(floor.areAllArrived(), () -> both + floor.reasons());
  }

  @AfterProperty
  void enoughCarriesWerePossible() {
    carries.assertPossible(0.2);
  }

  private List<Place> stations(Random random) {
    List<Place> places = new ArrayList<>(lab.stations());
    Collections.shuffle(places, random);
    return places;
  }

  /**
   * One that the planner finds possible: of those with room at both ends, so many are, for the
   * aisles between are narrower than the group.
   */
  private Carry carry(Random random) {
    return carry(random, any -> true);
  }

  private Carry carry(Random random, Predicate<Carry> isWanted) {
    while (true) {
      List<Place> places = stations(random);
      Vec2 from = places.get(0).position();
      Pose load = new Pose(from.x(), from.y(), random.nextInt(4) * Math.PI / 2);
      Vec2 to = places.get(1).position();
      Carry carry = new Carry(lab.grid(), load, to, 2 + random.nextInt(2));
      if (carry.hasRoom() && carries.count(carry.isPossible()) && isWanted.test(carry)) {
        return carry;
      }
    }
  }

  private List<Vec2> placesBeside(Carry carry) {
    return Stream.concat(lab.stations().stream(), lab.parking().stream())
        .map(Place::position)
        .filter(p -> p.distanceTo(carry.load().position()) > APART)
        .filter(p -> p.distanceTo(carry.goal()) > APART)
        .collect(Collectors.toCollection(ArrayList::new));
  }

  /**
   * @param load where it is picked up
   * @param goal where it is carried
   */
  private record Carry(OccupancyGrid grid, Pose load, Vec2 goal, int robots) {

    /** Whether a group has room at both ends, in the goal in one of eight headings. */
    boolean hasRoom() {
      DrivenFloor empty = new DrivenFloor(grid, 1);
      return hasRoom(empty, load)
          && IntStream.range(0, 8)
              .mapToObj(eighths -> new Pose(goal.x(), goal.y(), eighths * Math.PI / 4))
              .anyMatch(pose -> hasRoom(empty, pose));
    }

    private boolean hasRoom(DrivenFloor empty, Pose pose) {
      FormationFootprint group = group();
      return group.discs(group.shape().leaderAt(pose)).stream().allMatch(empty::isOffTheWalls);
    }

    /** Whether a group is told a path on an empty floor. */
    boolean isPossible() {
      return isPossible(GroupMobility.SHIFTING);
    }

    boolean isPossible(GroupMobility mobility) {
      return POSSIBLE.computeIfAbsent(
          List.of(load, goal, robots, mobility), key -> hasPath(mobility));
    }

    private boolean hasPath(GroupMobility mobility) {
      DrivenFloor empty = new DrivenFloor(grid, 1);
      begin(empty, "group", mobility);
      empty.step();
      return empty.isArrived("group") || empty.body("group").trajectory != null;
    }

    /** Whether each has a path while the other stands where it begins, and where it ends. */
    boolean goesWith(Carry other) {
      return hasPathBeside(other, other.leader())
          && hasPathBeside(other, other.end())
          && other.hasPathBeside(this, leader())
          && other.hasPathBeside(this, end());
    }

    private boolean hasPathBeside(Carry other, Pose standing) {
      DrivenFloor floor = new DrivenFloor(grid, 1);
      floor.putAt("other", standing, DrivenFloor.DIAMETER);
      floor.lead("other", other.group());
      floor.lose("other");
      begin(floor, "group");
      floor.step();
      return floor.isArrived("group") || floor.body("group").trajectory != null;
    }

    /** Where its leader is when it has arrived on an empty floor. */
    private Pose end() {
      DrivenFloor empty = new DrivenFloor(grid, 1);
      begin(empty, "group");
      empty.drive(LIMIT);
      return empty.body("group").pose;
    }

    boolean isNear(Carry other) {
      return Stream.of(load.position(), goal)
          .anyMatch(
              place ->
                  place.distanceTo(other.load.position()) < APART
                      || place.distanceTo(other.goal) < APART);
    }

    void begin(DrivenFloor floor, String name) {
      begin(floor, name, GroupMobility.SHIFTING);
    }

    private void begin(DrivenFloor floor, String name, GroupMobility mobility) {
      floor.putAt(name, leader(), DrivenFloor.DIAMETER);
      floor.lead(name, group(mobility));
      floor.sendTo(name, goal);
    }

    private Pose leader() {
      return group().shape().leaderAt(load);
    }

    private FormationFootprint group() {
      return group(GroupMobility.SHIFTING);
    }

    private FormationFootprint group(GroupMobility mobility) {
      double radius = DrivenFloor.DIAMETER / 2;
      Shape shape =
          robots == 2
              ? new Shape(new Vec2(LOAD, 0), List.of(new Vec2(-LOAD, 0)))
              : Shape.around(robots, LOAD, LOAD, radius);
      return new FormationFootprint(shape.withMobility(mobility), radius, LOAD, LOAD);
    }
  }
}
