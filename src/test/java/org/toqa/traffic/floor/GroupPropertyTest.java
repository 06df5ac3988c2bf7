package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.LongRange;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.FloorReader;
import org.toqa.grid.Place;

/** Robots that carry a load of 0.3 m together on the shipped floor. */
class GroupPropertyTest {
  private static final double LOAD = 0.3;

  /** Metres; tasks come to the places of others in turn. */
  private static final double APART = 1.2;

  private static final Duration LIMIT = Duration.ofMinutes(20);

  /** Held at any moment, a group has a way on from where it comes to a stand. */
  @Property(tries = 200, seed = "20261121")
  void groupThatIsHeldOnItsWayGoesOn(@ForAll @LongRange(min = 0) long seed) throws IOException {
    driveWithHolds(seed);
  }

  static void driveWithHolds(long seed) throws IOException {
    FloorMap lab = FloorReader.read(Path.of("maps", "lab.yaml"));
    Random random = new Random(seed);
    Place from = lab.stations().get(random.nextInt(lab.stations().size()));
    Place to = lab.stations().get(random.nextInt(lab.stations().size()));
    int robots = 2 + random.nextInt(2);
    DrivenFloor floor = new DrivenFloor(lab.grid(), seed);
    Pose load = new Pose(from.position().x(), from.position().y(), random.nextInt(4) * Math.PI / 2);
    if (!canCarry(lab, load, to.position(), robots)) {
      return;
    }
    put(floor, "group", load, robots);
    floor.sendTo("group", to.position());
    for (int i = 0; i < 8 && !floor.areAllArrived(); i++) {
      floor.drive(Duration.ofMillis(random.nextInt(8000)));
      floor.lose("group"); // nothing more can be told to it
      floor.drive(Duration.ofSeconds(20));
      floor.find("group");
    }
    floor.drive(LIMIT);
    assertTrue(floor.areAllArrived(), () -> from + " to " + to + " by " + robots + floor.reasons());
  }

  /** Among robots that drive to and fro, but not to its own places, it arrives, and so do they. */
  @Property(tries = 200, seed = "20261121")
  void groupArrivesAmongOthers(@ForAll @LongRange(min = 0) long seed) throws IOException {
    driveAmongOthers(seed);
  }

  static void driveAmongOthers(long seed) throws IOException {
    FloorMap lab = FloorReader.read(Path.of("maps", "lab.yaml"));
    Random random = new Random(seed);
    Place from = lab.stations().get(random.nextInt(lab.stations().size()));
    Place to = lab.stations().get(random.nextInt(lab.stations().size()));
    int robots = 2 + random.nextInt(2);
    Pose load = new Pose(from.position().x(), from.position().y(), random.nextInt(4) * Math.PI / 2);
    if (!canCarry(lab, load, to.position(), robots)) {
      return;
    }
    DrivenFloor floor = new DrivenFloor(lab.grid(), seed);
    put(floor, "group", load, robots);
    List<Vec2> places =
        Stream.concat(lab.stations().stream(), lab.parking().stream())
            .map(Place::position)
            .filter(
                p -> p.distanceTo(from.position()) > APART && p.distanceTo(to.position()) > APART)
            .collect(Collectors.toCollection(ArrayList::new));
    Collections.shuffle(places, random);
    int others = Math.min(1 + random.nextInt(6), places.size());
    for (int i = 0; i < others; i++) {
      floor.putAt("r" + i, places.get(i), DrivenFloor.DIAMETER);
    }
    floor.sendTo("group", to.position());
    Instant limit = floor.now.plus(LIMIT);
    while (!floor.isArrived("group") && floor.now.isBefore(limit)) {
      for (int i = 0; i < others; i++) {
        if (floor.isArrived("r" + i) && random.nextInt(100) == 0) {
          floor.sendTo(
              "r" + i, random.nextInt(4) == 0 ? null : places.get(random.nextInt(places.size())));
        }
      }
      floor.step();
    }
    assertTrue(
        floor.isArrived("group"), () -> from + " to " + to + " by " + robots + floor.reasons());
    for (int i = 0; i < others; i++) {
      floor.sendTo("r" + i, places.get(i));
    }
    floor.drive(LIMIT);
    assertTrue(floor.areAllArrived(), () -> floor.reasons().toString());
  }

  /** Two groups, whose places are apart, each arrive. */
  @Property(tries = 200, seed = "20261121")
  void twoGroupsArrive(@ForAll @LongRange(min = 0) long seed) throws IOException {
    driveTwoGroups(seed);
  }

  static void driveTwoGroups(long seed) throws IOException {
    FloorMap lab = FloorReader.read(Path.of("maps", "lab.yaml"));
    Random random = new Random(seed);
    List<Place> places = new ArrayList<>(lab.stations());
    Collections.shuffle(places, random);
    List<Pose> loads =
        places.subList(0, 2).stream()
            .map(p -> new Pose(p.position().x(), p.position().y(), random.nextInt(4) * Math.PI / 2))
            .toList();
    int robots = 2 + random.nextInt(2);
    for (int i = 0; i < 2; i++) {
      if (!canCarry(lab, loads.get(i), places.get(2 + i).position(), robots)) {
        return;
      }
    }
    DrivenFloor floor = new DrivenFloor(lab.grid(), seed);
    for (int i = 0; i < 2; i++) {
      put(floor, "g" + i, loads.get(i), robots);
      floor.sendTo("g" + i, places.get(2 + i).position());
    }
    floor.drive(LIMIT);
    assertTrue(floor.areAllArrived(), () -> places.subList(0, 4) + " " + floor.reasons());
  }

  private static boolean canCarry(FloorMap lab, Pose load, Vec2 to, int robots) {
    DrivenFloor empty = new DrivenFloor(lab.grid(), 1);
    Group group = group(robots);
    Pose leader = group.shape().leaderAt(load);
    if (!group.discs(leader).stream().allMatch(empty::isOffTheWalls)) {
      return false;
    }
    put(empty, "group", load, robots);
    empty.sendTo("group", to);
    empty.step();
    return empty.isArrived("group") || empty.body("group").way != null;
  }

  private static void put(DrivenFloor floor, String name, Pose load, int robots) {
    Group group = group(robots);
    floor.putAt(name, group.shape().leaderAt(load), DrivenFloor.DIAMETER);
    floor.lead(name, group);
  }

  private static Group group(int robots) {
    double radius = DrivenFloor.DIAMETER / 2;
    return new Group(
        robots == 2
            ? new Shape(new Vec2(LOAD, 0), List.of(new Vec2(-LOAD, 0)))
            : Shape.around(robots, LOAD, LOAD, radius),
        radius,
        LOAD,
        LOAD);
  }
}
