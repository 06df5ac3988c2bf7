package org.toqa.sim;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.config.ArmConfig;
import org.toqa.arm.Arm;
import org.toqa.arm.JointAngles;
import org.toqa.arm.JointLimits;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.sim.SimulatedBoxes.Placed;
import org.toqa.yaml.YamlParser;
import org.toqa.yaml.YamlSyntaxException;

/**
 * Boxes on a simulated floor, and which simulated robots see and lift them, as a file has it:
 *
 * <pre>
 * floor: store
 * arms: [r1, r2]
 * cameras: [r3]
 * cameraRange: 4
 * boxes:
 *   - {number: 1, x: 3.2, y: 7.5, weight: 1.8}
 * </pre>
 *
 * @param arms names of the robots that have one
 * @param cameras names of the robots that have them
 * @param cameraRange metres
 */
public record SimulatedStore(
    String floor, Set<String> arms, Set<String> cameras, double cameraRange, List<Placed> boxes) {

  private static final double LONGEST_VIEW = 100;
  private static final double HEAVIEST = 1_000;
  private static final double FARTHEST = 100_000;
  private static final int MAX_BOXES = 200;

  private static final List<String> KEYS =
      List.of("floor", "arms", "cameras", "cameraRange", "boxes");

  public SimulatedStore {
    arms = Set.copyOf(arms);
    cameras = Set.copyOf(cameras);
    boxes = List.copyOf(boxes);
  }

  /**
   * @throws IOException with a sentence for people: the file cannot be read, or the key and what it
   *     must be
   */
  public static SimulatedStore read(Path file) throws IOException {
    try {
      if (!(YamlParser.parse(Files.readString(file)) instanceof Map<?, ?> top)) {
        throw new IOException(file + ": this is not a list of keys and values.");
      }
      for (Object key : top.keySet()) {
        if (!KEYS.contains(String.valueOf(key))) {
          throw wrong(
              file, String.valueOf(key), "is not known; known are " + String.join(", ", KEYS));
        }
      }
      if (!(top.get("floor") instanceof String floor)) {
        throw wrong(file, "floor", "must be the name of a floor");
      }
      return new SimulatedStore(
          floor,
          names(file, top, "arms"),
          names(file, top, "cameras"),
          number(file, top, "cameraRange", 0.1, LONGEST_VIEW),
          boxes(file, top.get("boxes")));
    } catch (NoSuchFileException e) {
      throw new IOException(file + ": there is no such file.", e);
    } catch (CharacterCodingException e) {
      throw new IOException(file + ": this is not text in UTF-8.", e);
    } catch (YamlSyntaxException e) {
      throw new IOException(file + ": not valid YAML (" + e.problem() + ").", e);
    }
  }

  private static List<Placed> boxes(Path file, @Nullable Object given) throws IOException {
    if (!(given instanceof List<?> list) || list.size() > MAX_BOXES) {
      throw wrong(file, "boxes", "must be a list of at most " + MAX_BOXES + " boxes");
    }
    List<Placed> boxes = new ArrayList<>();
    Set<Integer> numbers = new HashSet<>();
    for (Object item : list) {
      if (!(item instanceof Map<?, ?> box)
          || !(box.get("number") instanceof Integer number)
          || number < 1
          || !numbers.add(number)) {
        throw wrong(
            file, "boxes", "must each have a number above 0 that no other has, x, y and weight");
      }
      boxes.add(
          new Placed(
              number,
              new Vec2(
                  number(file, box, "x", -FARTHEST, FARTHEST),
                  number(file, box, "y", -FARTHEST, FARTHEST)),
              number(file, box, "weight", 0.1, HEAVIEST)));
    }
    return boxes;
  }

  private static Set<String> names(Path file, Map<?, ?> top, String key) throws IOException {
    Set<String> names = new HashSet<>();
    if (!(top.get(key) instanceof List<?> list)) {
      throw wrong(file, key, "must be a list of robots' names");
    }
    list.forEach(name -> names.add(String.valueOf(name)));
    return names;
  }

  private static double number(Path file, Map<?, ?> fields, String key, double least, double most)
      throws IOException {
    if (fields.get(key) instanceof Number number
        && number.doubleValue() >= least
        && number.doubleValue() <= most) {
      return number.doubleValue();
    }
    throw wrong(file, key, "must be a number from " + least + " to " + most);
  }

  private static IOException wrong(Path file, String key, String must) {
    return new IOException("%s: \"%s\" %s.".formatted(file, key, must));
  }

  /** What of it a robot has. */
  public SimulatedRobot equipped(SimulatedRobot robot) {
    SimulatedRobot armed =
        arms.contains(robot.name())
            ? robot.withArm(new ArmConfig(arm(robot.maxLoad()), null))
            : robot;
    return cameras.contains(robot.name()) ? armed.withCamera(cameraRange) : armed;
  }

  /** That of {@code raspberry-agent/agent.yaml}, as strong as its robot. */
  private static Arm arm(double maxLoad) {
    JointLimits joint =
        new JointLimits(
            Math.toRadians(-160), Math.toRadians(160), Math.toRadians(90), Math.toRadians(180));
    return new Arm(
        0.3,
        0.25,
        new Pose(0.05, 0, 0),
        joint,
        joint,
        maxLoad,
        new JointAngles(Math.toRadians(120), Math.toRadians(-150)));
  }
}
