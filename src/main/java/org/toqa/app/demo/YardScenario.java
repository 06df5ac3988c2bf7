package org.toqa.app.demo;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.toqa.app.server.FleetServer;
import org.toqa.app.server.FleetServer.BodyObservation;
import org.toqa.fleet.TaskOrder;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Area;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorWriter;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.sim.Body;
import org.toqa.sim.VirtualClock;

/**
 * Four agents in one robot as an ordinary part of Toqa: on a floor with a free zone in its middle,
 * where two people walk to and fro, two robots cross it by themselves, one after the other.
 */
final class YardScenario {
  static final String ROBOTS = "2";

  private static final String FLOOR = "yard";
  private static final double CELL = 0.3;
  private static final int COLUMNS = 36;
  private static final int ROWS = 16;
  private static final Area ZONE = new Area(new Vec2(3.3, 0.3), 4.2, 4.2);
  private static final double PERSON_RADIUS = 0.15;

  /** Metres a second at most: half of what a robot drives. */
  private static final double WALK_SPEED = 0.12;

  /** Metres to both sides of where somebody walks. */
  private static final double WALK = 0.9;

  /**
   * Metres between the middles of somebody and of a robot, within which he does not come nearer.
   */
  private static final double POLITE = 0.5;

  private YardScenario() {}

  /**
   * The map, as the configuration names it.
   *
   * @param folder gets it
   */
  static String map(Path folder) throws IOException {
    Files.createDirectories(folder);
    FloorWriter.mapServerFiles(FLOOR, drawing()).writeTo(folder);
    return folder.resolve(FLOOR + ".yaml").toString();
  }

  private static FloorDrawing drawing() {
    String wall = "#".repeat(COLUMNS);
    String row = "#" + ".".repeat(COLUMNS - 2) + "#";
    String[] rows = new String[ROWS];
    for (int i = 0; i < ROWS; i++) {
      rows[i] = i == 0 || i == ROWS - 1 ? wall : row;
    }
    OccupancyGrid drawn = OccupancyGrid.parse(rows);
    return new FloorDrawing(
            new OccupancyGrid(COLUMNS, ROWS, CELL, Vec2.ZERO, drawn.occupied()),
            List.of(
                new Place("West gate", new Vec2(1.05, 1.65)),
                new Place("West store", new Vec2(1.05, 3.15)),
                new Place("East gate", new Vec2(9.75, 1.65)),
                new Place("East store", new Vec2(9.75, 3.15))),
            List.of(new Place("Y1", new Vec2(0.75, 0.75)), new Place("Y2", new Vec2(10.05, 0.75))),
            List.of(new Place("Y charge", new Vec2(0.75, 4.05))),
            List.of(),
            List.of(),
            List.of())
        .withFreeZones(List.of(ZONE));
  }

  static List<TaskOrder> orders() {
    return List.of(
        DemoTasks.order("Crates to the east", 3, "West gate", "East gate", FLOOR),
        DemoTasks.order("Empties to the west", 1, "East store", "West store", FLOOR),
        DemoTasks.order("Tools to the east", 2, "West store", "East store", FLOOR),
        DemoTasks.order("Parcel to the west", 1.5, "East gate", "West gate", FLOOR));
  }

  /** People walk in the zone until this is closed. */
  static BodyObservation begin(FleetServer toqa) {
    List<Person> people = people();
    return toqa.observeBodies(
        FLOOR,
        (_, bodies) -> {
          for (Person person : people) {
            person.step(bodies);
            toqa.putObstacle(FLOOR, person.name, person.place(), PERSON_RADIUS);
          }
        });
  }

  static List<Person> people() {
    return List.of(
        new Person("first person", new Vec2(4.7, 2.4), 0),
        new Person("second person", new Vec2(6.1, 2.4), Math.PI / 2));
  }

  /** Walks to and fro, and stands while a robot is before him. For one thread. */
  static final class Person {
    private final String name;
    private final Vec2 middle;
    private double phase;

    /**
     * @param middle of his walk, metres, map frame
     * @param phase radians: where he begins
     */
    Person(String name, Vec2 middle, double phase) {
      this.name = name;
      this.middle = middle;
      this.phase = phase;
    }

    /** Metres, map frame. */
    Vec2 place() {
      return placeAt(phase);
    }

    private Vec2 placeAt(double there) {
      return middle.plus(new Vec2(0, WALK * Math.sin(there)));
    }

    /** One step of the simulated world. */
    void step(List<Body> bodies) {
      double next = phase + WALK_SPEED / WALK * VirtualClock.STEP.toNanos() / 1e9;
      Vec2 place = placeAt(next);
      boolean isFree =
          bodies.stream()
              .flatMap(body -> body.core().stream())
              .allMatch(
                  robot ->
                      robot.distanceTo(place) > POLITE
                          || robot.distanceTo(place) > robot.distanceTo(place()));
      phase = isFree ? next : phase;
    }
  }
}
