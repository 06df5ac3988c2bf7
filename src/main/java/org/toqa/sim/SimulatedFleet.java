package org.toqa.sim;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BiConsumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.agent.Daemon;
import org.toqa.agent.TickSchedule;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.config.AgentConfig;
import org.toqa.agent.config.ChassisConfig;
import org.toqa.agent.drive.MotionLimits;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;

/**
 * Simulated robots: real daemons over simulated bodies, each behind a TCP port of its own on
 * loopback, all in one process and by one clock. A robot whose folder is found is where it was,
 * with its journal; the ports are new at every start.
 */
public final class SimulatedFleet implements AutoCloseable {

  private static final Logger log = LoggerFactory.getLogger(SimulatedFleet.class);

  /** The diameter of a simulated robot, metres. */
  public static final double FOOTPRINT = 0.255;

  private static final int ANY_FREE_PORT = 0;
  private static final MotionLimits LIMITS = new MotionLimits(0.5, 3.5, 0.5, 3);
  private static final double SLIP = 0.01;

  /** By name. */
  private final Map<String, SimulatedFloor> floors = new ConcurrentHashMap<>();

  /** By robot; of those whose bodies are simulated as a whole. */
  private final Map<String, FloorOfBody> bodies = new HashMap<>();

  private final VirtualClock clock;
  private final List<SimulatedDaemon> robots = new ArrayList<>();
  private final List<SimulatedMicrocontroller> microcontrollers = new ArrayList<>();

  /** A daemon in the world, which is ticked when it would be on a robot. */
  private record SimulatedDaemon(Daemon daemon, TickSchedule schedule) implements Participant {
    @Override
    public void tick(long nanos) {
      if (schedule.nanosUntilDue(nanos) <= 0) {
        schedule.tick(nanos);
      }
    }

    @Override
    public boolean isReady(long nanos) {
      return !daemon.isWaitingForServer(nanos) && !daemon.isWaitingForLeader(nanos);
    }

    @Override
    public String toString() {
      return daemon.robot();
    }
  }

  /**
   * Makes the robots, or finds them again, and lets them live by the clock.
   *
   * @param folder one folder for each robot is kept in it, with the robot's name
   * @param floor where they are and drive
   * @throws IOException when a robot's folder or port is not usable; then none of them runs
   */
  public static SimulatedFleet open(
      Path folder, List<SimulatedRobot> robots, SimulatedFloor floor, VirtualClock clock)
      throws IOException {
    return open(folder, Map.of(floor, robots), clock);
  }

  /**
   * The same on several floors.
   *
   * @param robots by the floor where they are and drive
   */
  public static SimulatedFleet open(
      Path folder, Map<SimulatedFloor, List<SimulatedRobot>> robots, VirtualClock clock)
      throws IOException {
    SimulatedFleet fleet = new SimulatedFleet(clock);
    try {
      robots.keySet().forEach(floor -> fleet.floors.put(floor.name(), floor));
      for (Map.Entry<SimulatedFloor, List<SimulatedRobot>> floor : robots.entrySet()) {
        for (SimulatedRobot robot : floor.getValue()) {
          fleet.add(folder.resolve(robot.name()), robot, floor.getKey());
        }
      }
      return fleet;
    } catch (IOException e) {
      fleet.close();
      throw e;
    }
  }

  private SimulatedFleet(VirtualClock clock) {
    this.clock = clock;
  }

  /**
   * The port of TCP on which the robot listens, on loopback.
   *
   * @throws IllegalArgumentException if there is no such robot
   */
  public int port(String robot) {
    return daemon(robot).port();
  }

  /** Whether one of the robots listens on that port of loopback. */
  public boolean isListeningOn(int port) {
    return robots.stream().anyMatch(robot -> robot.daemon().port() == port);
  }

  /**
   * Whether something that the robot has received waits for its next tick.
   *
   * @throws IllegalArgumentException if there is no such robot
   */
  public boolean hasPendingMessages(String robot) {
    return daemon(robot).hasPendingMessages();
  }

  /**
   * Whether so many messages of the server that is connected have come to the robot. For the thread
   * of the clock, as the next one.
   *
   * @throws IllegalArgumentException if there is no such robot
   */
  public boolean hasReceivedFromServer(String robot, long messages) {
    return daemon(robot).hasReceivedFromServer(messages);
  }

  /**
   * How many messages the robot has sent the server that is connected, its hello included; 0: there
   * is none.
   *
   * @throws IllegalArgumentException if there is no such robot
   */
  public long sentToServer(String robot) {
    return daemon(robot).sentToServer();
  }

  private Daemon daemon(String robot) {
    return robots.stream()
        .map(SimulatedDaemon::daemon)
        .filter(daemon -> daemon.robot().equals(robot))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException("There is no robot " + robot + "."));
  }

  /** Where the robot really is, map frame; empty where its body is not simulated as a whole. */
  public Optional<Pose> truePose(String robot) {
    return Optional.ofNullable(bodies.get(robot)).flatMap(body -> body.floor().truePose(robot));
  }

  /**
   * The robots of a floor where they really are, but for those whose bodies are not simulated as a
   * whole.
   */
  public List<Body> bodies(String floor) {
    SimulatedFloor there = floors.get(floor);
    return there == null ? List.of() : there.bodies();
  }

  /** From now on walls and chargers of the floor are where this map has them. */
  public void rebuild(FloorMap floor) {
    SimulatedFloor there = floors.get(floor.name());
    if (there != null) {
      there.rebuild(floor);
    }
  }

  /**
   * People carry the robot: at its next tick its body stands there. Its daemon does not know it,
   * and must be told where it is. A robot whose body is not simulated as a whole has none to be
   * carried; one that is not of this fleet stays where it is.
   *
   * @param pose map frame of that floor
   */
  public void carry(String robot, FloorMap floor, Pose pose) {
    FloorOfBody body = bodies.get(robot);
    if (body != null) {
      body.carry(floors.computeIfAbsent(floor.name(), _ -> SimulatedFloor.of(floor)), pose);
    }
  }

  /**
   * Whether the robot that is kept in its folder was not carried to that floor, though it should
   * be: the process ended before.
   *
   * @param folder the robot's
   * @throws IOException the folder cannot be read
   */
  public static boolean isElsewhere(Path folder, String floor) throws IOException {
    return FloorOfBody.isElsewhere(folder, floor);
  }

  /**
   * Puts an obstacle on a floor, or moves it; nothing where there is no such floor.
   *
   * @param name of its own
   * @param middle metres, map frame
   * @param radius metres
   */
  public void putObstacle(String floor, String name, Vec2 middle, double radius) {
    SimulatedFloor there = floors.get(floor);
    if (there != null) {
      there.putObstacle(name, middle, radius);
    }
  }

  /**
   * From now on the observer is told of each pose that a robot reports, before it is sent.
   *
   * @param observer called by the world's threads, with the robot's name; it does not wait
   */
  public void observeReports(BiConsumer<String, Pose> observer) {
    for (SimulatedDaemon robot : robots) {
      String name = robot.daemon().robot();
      robot.daemon().setPoseListener(pose -> observer.accept(name, pose));
    }
  }

  /** Takes the robots out of the world, the last one first, and ends their daemons. */
  @Override
  public void close() {
    for (SimulatedDaemon robot : robots.reversed()) {
      clock.remove(robot);
      try {
        robot.daemon().close();
      } catch (IOException e) {
        log.warn("{}: could not be ended cleanly.", robot, e);
      }
    }
    robots.clear();
    microcontrollers.forEach(SimulatedMicrocontroller::close);
    microcontrollers.clear();
  }

  private ChassisConfig createBody(Path folder, SimulatedRobot robot, SimulatedFloor floor)
      throws IOException {
    Path firmware = robot.firmware();
    if (firmware == null) {
      FloorOfBody body = new FloorOfBody(robot, FOOTPRINT / 2, folder, floor);
      bodies.put(robot.name(), body);
      return new ChassisConfig.Simulated(
          robot.start(),
          new SimulatedBattery(robot.battery(), body.chargers()),
          SLIP,
          robot.name().hashCode(),
          1,
          body);
    }
    Files.createDirectories(folder);
    SimulatedMicrocontroller microcontroller = SimulatedMicrocontroller.start(firmware, folder);
    microcontrollers.add(microcontroller);
    return new ChassisConfig.SimulatedFirmware(microcontroller.socket(), robot.start(), true);
  }

  private void add(Path folder, SimulatedRobot robot, SimulatedFloor floor) throws IOException {
    AgentConfig config =
        new AgentConfig(
            robot.name(),
            InetAddress.getLoopbackAddress(),
            ANY_FREE_PORT,
            false,
            folder,
            robot.maxLoad(),
            FOOTPRINT,
            robot.kind(),
            LIMITS,
            AgentConfig.Following.of(robot.kind()),
            createBody(folder, robot, floor),
            robot.arm(),
            robot.avoidance(),
            null);
    Daemon daemon = Daemon.open(config, clock, clock.nanos());
    SimulatedDaemon inhabitant =
        new SimulatedDaemon(daemon, new TickSchedule(daemon, clock.nanos()));
    robots.add(inhabitant);
    clock.add(inhabitant, Chassis.TICK);
  }
}
