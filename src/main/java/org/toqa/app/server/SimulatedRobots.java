package org.toqa.app.server;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.config.Avoidance;
import org.toqa.app.command.TemporaryFolder;
import org.toqa.app.config.Configuration;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.LastPlace;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.StoredRobot;
import org.toqa.geometry.Pose;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;
import org.toqa.persistence.StoreException;
import org.toqa.sim.SimulatedBoxes;
import org.toqa.sim.SimulatedFleet;
import org.toqa.sim.SimulatedFloor;
import org.toqa.sim.SimulatedRobot;
import org.toqa.sim.SimulatedStore;
import org.toqa.sim.VirtualClock;

/** The robots that live in the server's process, as the configuration wants them. */
final class SimulatedRobots {
  /** Kilograms. */
  private static final double MAX_LOAD = 5;

  private SimulatedRobots() {}

  /**
   * Makes the robots r1 to rN, floor by floor, or finds them again with what people have changed,
   * and tells the store where they listen.
   *
   * @throws IOException when a floor has no room for them, or they cannot be simulated or stored;
   *     the message says what to do
   */
  static SimulatedFleet start(
      Configuration configuration, List<FloorMap> floors, FleetStore store, VirtualClock clock)
      throws IOException {
    Path folders = configuration.data().resolve("robots");
    List<RobotRecord> fresh = new ArrayList<>();
    Map<String, SimulatedFloor> worlds = new LinkedHashMap<>();
    floors.forEach(floor -> worlds.put(floor.name(), SimulatedFloor.of(floor)));
    SimulatedStore boxes = putBoxes(configuration, worlds);
    Map<SimulatedFloor, List<SimulatedRobot>> robots = new LinkedHashMap<>();
    worlds.values().forEach(world -> robots.put(world, new ArrayList<>()));
    Map<String, StoredRobot> known = knownRobots(store, configuration, worlds.keySet(), folders);
    int made = 0;
    for (int i = 0; i < configuration.simulatedRobots().size(); i++) {
      FloorMap floor = floors.get(Math.min(i, floors.size() - 1));
      List<Place> places = startPlaces(floor, configuration.simulatedRobots().get(i));
      for (int j = 0; j < places.size(); j++) {
        String name = "r" + (made + 1);
        Path firmware = made == 0 ? configuration.firmware() : null;
        StoredRobot before = known.get(name);
        SimulatedRobot robot =
            new SimulatedRobot(
                name,
                start(folders.resolve(name), before, places.get(j)),
                MAX_LOAD,
                initialBattery(configuration, made),
                firmware);
        String where = before == null ? floor.name() : before.record().floor();
        requireNonNull(robots.get(worlds.get(where)))
            .add(equipped(robot, configuration.simulatedAvoidance(), boxes));
        String parking = j < floor.parking().size() ? places.get(j).name() : null;
        fresh.add(
            before == null
                ? RobotRecord.direct(
                    name, floor.name(), "127.0.0.1", 1, MAX_LOAD, parking, true, null)
                : before.record());
        made++;
      }
    }
    SimulatedFleet simulated = SimulatedFleet.open(folders, robots, clock);
    try {
      for (RobotRecord robot : fresh) {
        store.saveRobot(robot.withAddress("127.0.0.1", simulated.port(robot.name())));
      }
      return simulated;
    } catch (StoreException e) {
      simulated.close();
      throw cannotBeStored(e);
    }
  }

  private static SimulatedRobot equipped(
      SimulatedRobot robot, Avoidance avoidance, @Nullable SimulatedStore boxes) {
    SimulatedRobot avoiding = avoidance == Avoidance.FOUR_AGENTS ? robot.withFourAgents() : robot;
    return boxes == null ? avoiding : boxes.equipped(avoiding);
  }

  /**
   * Puts the boxes where they were left, or as they are at first.
   *
   * @return null: there are none
   */
  private static @Nullable SimulatedStore putBoxes(
      Configuration configuration, Map<String, SimulatedFloor> worlds) throws IOException {
    Path file = configuration.simulatedBoxes();
    if (file == null) {
      return null;
    }
    SimulatedStore boxes = SimulatedStore.read(file);
    SimulatedFloor world = worlds.get(boxes.floor());
    if (world == null) {
      throw new IOException(
          "%s: there is no floor %s; the floors are %s."
              .formatted(file, boxes.floor(), String.join(", ", worlds.keySet())));
    }
    world.putBoxes(
        SimulatedBoxes.open(configuration.data().resolve("robots/boxes"), boxes.boxes()));
    return boxes;
  }

  /** Where a body is put if none is kept: where its robot stood last, else at its first place. */
  private static Pose start(Path folder, @Nullable StoredRobot before, Place first) {
    LastPlace place = before == null || Files.exists(folder) ? null : before.place();
    return place == null ? new Pose(first.position().x(), first.position().y(), 0) : place.pose();
  }

  /**
   * Those that are on floors that there are; who is on another one begins anew, and so does a body
   * that was not yet carried to the floor of its robot when the server was killed.
   */
  private static Map<String, StoredRobot> knownRobots(
      FleetStore store, Configuration configuration, Set<String> floors, Path folders)
      throws IOException {
    int count = configuration.simulatedRobots().stream().mapToInt(Integer::intValue).sum();
    try {
      Map<String, StoredRobot> known = new HashMap<>();
      for (StoredRobot robot : store.storedRobots()) {
        if (robot.record().simulated() && isOneOf(robot.name(), count)) {
          Path folder = folders.resolve(robot.name());
          String floor = robot.record().floor();
          if (floors.contains(floor)) {
            known.put(robot.name(), robot);
          }
          if (!floors.contains(floor) || SimulatedFleet.isElsewhere(folder, floor)) {
            new TemporaryFolder(folder).close();
          }
        }
      }
      return known;
    } catch (StoreException e) {
      throw cannotBeStored(e);
    }
  }

  private static boolean isOneOf(String name, int count) {
    return IntStream.rangeClosed(1, count).anyMatch(i -> name.equals("r" + i));
  }

  private static IOException cannotBeStored(StoreException e) {
    return new IOException("The simulated robots cannot be stored: " + e.getMessage(), e);
  }

  private static double initialBattery(Configuration configuration, int robot) {
    List<Double> batteries = configuration.simulatedBatteries();
    return batteries.get(Math.min(robot, batteries.size() - 1));
  }

  /** Where robots begin: the parking points, and where these do not suffice, free cells. */
  private static List<Place> startPlaces(FloorMap floor, int count) throws IOException {
    List<Place> places =
        Stream.concat(floor.parking().stream(), FreeCells.of(floor)).limit(count).toList();
    if (places.size() < count) {
      throw new IOException(
          "The floor "
              + floor.name()
              + " has no room for so many robots; simulate "
              + places.size()
              + " at most.");
    }
    return places;
  }
}
