package org.toqa.app.server;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.toqa.app.command.TemporaryFolder;
import org.toqa.app.config.Configuration;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.RobotRecord;
import org.toqa.geometry.Pose;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;
import org.toqa.persistence.StoreException;
import org.toqa.sim.SimulatedFleet;
import org.toqa.sim.SimulatedFloor;
import org.toqa.sim.SimulatedRobot;
import org.toqa.sim.VirtualClock;

/** The robots that live in the server's process, as the configuration wants them. */
final class SimulatedRobots {
  /** Kilograms. */
  private static final double MAX_LOAD = 5;

  private SimulatedRobots() {}

  /**
   * Makes the robots r1 to rN, or finds them again with what people have changed, and tells the
   * store where they listen.
   *
   * @throws IOException when the map has no room for them, or they cannot be simulated or stored;
   *     the message says what to do
   */
  static SimulatedFleet start(
      Configuration configuration, FloorMap floor, FleetStore store, VirtualClock clock)
      throws IOException {
    List<Place> places = startPlaces(floor, configuration.simulatedRobots());
    List<SimulatedRobot> robots = new ArrayList<>();
    for (int i = 0; i < configuration.simulatedRobots(); i++) {
      Pose start = new Pose(places.get(i).position().x(), places.get(i).position().y(), 0);
      Path firmware = i == 0 ? configuration.firmware() : null;
      robots.add(
          new SimulatedRobot(
              "r" + (i + 1), start, MAX_LOAD, initialBattery(configuration, i), firmware));
    }
    Path folders = configuration.data().resolve("robots");
    List<RobotRecord> known = knownRobots(store, robots, floor, folders);
    SimulatedFleet simulated =
        SimulatedFleet.open(folders, robots, SimulatedFloor.of(floor), clock);
    try {
      for (int i = 0; i < robots.size(); i++) {
        String name = robots.get(i).name();
        int port = simulated.port(name);
        String parking = i < floor.parking().size() ? places.get(i).name() : null;
        RobotRecord fresh =
            RobotRecord.direct(
                name, floor.name(), "127.0.0.1", port, MAX_LOAD, parking, true, null);
        store.saveRobot(
            known.stream()
                .filter(r -> r.name().equals(name))
                .findFirst()
                .map(r -> r.withAddress("127.0.0.1", port))
                .orElse(fresh));
      }
      return simulated;
    } catch (StoreException e) {
      simulated.close();
      throw cannotBeStored(e);
    }
  }

  /** Those of them that are on the floor; who is on a floor of another map begins anew here. */
  private static List<RobotRecord> knownRobots(
      FleetStore store, List<SimulatedRobot> robots, FloorMap floor, Path folders)
      throws IOException {
    try {
      List<RobotRecord> known = new ArrayList<>();
      List<String> names = robots.stream().map(SimulatedRobot::name).toList();
      for (RobotRecord robot : store.robots()) {
        if (robot.simulated() && names.contains(robot.name())) {
          if (robot.floor().equals(floor.name())) {
            known.add(robot);
          } else {
            new TemporaryFolder(folders.resolve(robot.name())).close();
          }
        }
      }
      return known;
    } catch (StoreException e) {
      throw cannotBeStored(e);
    }
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
          "The map "
              + floor.name()
              + " has no room for so many robots; simulate "
              + places.size()
              + " at most.");
    }
    return places;
  }
}
