package org.toqa.sim;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.AbstractList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.agent.chassis.SharedLoad;
import org.toqa.agent.chassis.Surroundings;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.CameraView;

/**
 * The floor on which a body is, and how people carry it to another one: at its next tick it stands
 * there, and is gone from where it was.
 *
 * <p>Which floor that is is kept in the robot's folder, after the body's own state; so a process
 * that is killed between the two leaves a floor that {@link #isElsewhere} tells.
 *
 * <p>{@link #carry} and {@link #floor} may be called by any thread, all else by the body's.
 */
final class FloorOfBody implements Surroundings {
  private static final Logger log = LoggerFactory.getLogger(FloorOfBody.class);
  private static final String FILE = "floor";

  private final String robot;
  private final double radius;
  private final double cameraRange;
  private final Path folder;
  private final AtomicReference<@Nullable Carried> carried = new AtomicReference<>();
  private volatile SimulatedFloor floor;
  private Surroundings surroundings;
  private boolean isStored;

  private record Carried(SimulatedFloor to, Pose pose) {}

  /**
   * @param robot whose it is, with its cameras
   * @param radius of that robot, metres
   * @param folder the robot's
   */
  FloorOfBody(SimulatedRobot robot, double radius, Path folder, SimulatedFloor floor) {
    this.robot = robot.name();
    this.radius = radius;
    this.cameraRange = robot.cameraRange();
    this.folder = folder;
    this.floor = floor;
    this.surroundings = enter(floor, robot.name(), radius, cameraRange);
  }

  /**
   * Whether the body that is kept in a folder stands on another floor.
   *
   * @throws IOException the folder cannot be read
   */
  static boolean isElsewhere(Path folder, String floor) throws IOException {
    Path file = folder.resolve(FILE);
    return Files.exists(file) && !Files.readString(file, StandardCharsets.UTF_8).equals(floor);
  }

  private static Surroundings enter(
      SimulatedFloor floor, String robot, double radius, double cameraRange) {
    if (cameraRange > 0) {
      floor.mountCamera(robot, cameraRange);
    }
    return floor.surroundings(robot, radius);
  }

  SimulatedFloor floor() {
    return floor;
  }

  /**
   * Puts the body on that floor, at its next tick.
   *
   * @param pose map frame of that floor
   */
  void carry(SimulatedFloor to, Pose pose) {
    carried.set(new Carried(to, pose));
  }

  /** Where it is charged on the floor where it is. */
  List<Vec2> chargers() {
    return new AbstractList<>() {
      @Override
      public Vec2 get(int index) {
        return floor.chargers().get(index);
      }

      @Override
      public int size() {
        return floor.chargers().size();
      }

      @Override
      public Iterator<Vec2> iterator() { // of one floor and map, whatever becomes of them meanwhile
        return floor.chargers().iterator();
      }
    };
  }

  @Override
  public Optional<Pose> takePlace() {
    Carried to = carried.getAndSet(null);
    if (to == null) {
      return Optional.empty();
    }
    floor.removeRobot(robot);
    floor = to.to();
    surroundings = enter(floor, robot, radius, cameraRange);
    isStored = false;
    return Optional.of(to.pose());
  }

  @Override
  public void setTruePose(Pose truth) {
    surroundings.setTruePose(truth);
    if (!isStored) {
      isStored = true;
      storeFloor();
    }
  }

  private void storeFloor() {
    try {
      Files.writeString(folder.resolve(FILE), floor.name(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      log.warn("{}: its floor could not be kept.", robot, e);
    }
  }

  @Override
  public void setSharedLoad(@Nullable SharedLoad load) {
    surroundings.setSharedLoad(load);
  }

  @Override
  public OptionalDouble borneShare() {
    return surroundings.borneShare();
  }

  @Override
  public @Nullable CameraView view(Vec2 from) {
    return surroundings.view(from);
  }

  @Override
  public OptionalDouble grasp(Vec2 hand) {
    return surroundings.grasp(hand);
  }

  @Override
  public void release(Vec2 hand) {
    surroundings.release(hand);
  }

  @Override
  public double distance(Pose ray, double farthest) {
    return surroundings.distance(ray, farthest);
  }

  @Override
  public boolean isMarked(Vec2 point) {
    return surroundings.isMarked(point);
  }
}
