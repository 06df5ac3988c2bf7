package org.toqa.sim;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/**
 * The boxes of a simulated world: where each truly lies, or who has it. Kept in a file, so that
 * they are where they were when the process was killed. May be used by any thread.
 *
 * <p>A line of the file: number, kilograms, x, y, and whose it is; {@code -} while it lies.
 */
public final class SimulatedBoxes {
  /** Metres; a hand that closes so near to a box's middle has it. */
  private static final double GRASP_REACH = 0.1;

  /** Metres; a load that several lift there is the box that lies so near. */
  private static final double LIFT_REACH = 0.3;

  private static final String NOBODY = "-";

  private final Map<Integer, Box> boxes = new TreeMap<>();
  private final @Nullable Path file;

  /**
   * A box.
   *
   * @param kilograms above 0
   * @param place metres, map frame; while somebody has it, where it lay
   * @param holder null: it lies
   */
  private record Box(double kilograms, Vec2 place, @Nullable String holder) {
    Box heldBy(String who) {
      return new Box(kilograms, place, who);
    }

    Box lyingAt(Vec2 there) {
      return new Box(kilograms, there, null);
    }
  }

  /**
   * A box as it is at first.
   *
   * @param number above 0
   * @param place metres, map frame
   * @param kilograms above 0
   */
  public record Placed(int number, Vec2 place, double kilograms) {}

  private SimulatedBoxes(Collection<Placed> initial, @Nullable Path file) {
    this.file = file;
    initial.forEach(b -> boxes.put(b.number(), new Box(b.kilograms(), b.place(), null)));
  }

  /** Of one life of the process only. */
  public static SimulatedBoxes of(Collection<Placed> initial) {
    return new SimulatedBoxes(initial, null);
  }

  /**
   * As they were left, or as they are at first.
   *
   * @throws IOException when the file cannot be read or written, or is not of ours
   */
  public static SimulatedBoxes open(Path file, Collection<Placed> initial) throws IOException {
    SimulatedBoxes found = new SimulatedBoxes(initial, file);
    if (Files.exists(file)) {
      found.boxes.clear();
      for (String line : Files.readAllLines(file)) {
        found.read(line);
      }
    } else {
      Files.createDirectories(file.toAbsolutePath().getParent());
      found.write();
    }
    return found;
  }

  private void read(String line) throws IOException {
    String[] words = line.split(" ", 5);
    try {
      Vec2 place = new Vec2(Double.parseDouble(words[2]), Double.parseDouble(words[3]));
      String holder = words[4].equals(NOBODY) ? null : words[4];
      boxes.put(Integer.parseInt(words[0]), new Box(Double.parseDouble(words[1]), place, holder));
    } catch (NumberFormatException | IndexOutOfBoundsException e) {
      throw new IOException(file + ": this line is no box: " + line, e);
    }
  }

  /** The boxes that lie, by number. */
  synchronized Map<Integer, Vec2> lying() {
    Map<Integer, Vec2> lying = new TreeMap<>();
    boxes.forEach(
        (number, box) -> {
          if (box.holder() == null) {
            lying.put(number, box.place());
          }
        });
    return lying;
  }

  /** Where a box lies, metres, map frame; empty while somebody has it. */
  public synchronized Optional<Vec2> placeOf(int number) {
    return Optional.ofNullable(lying().get(number));
  }

  /**
   * A hand closes; its robot has the box from now on.
   *
   * @return kilograms; 0: there is none
   */
  synchronized double grasp(String robot, Vec2 hand) {
    Integer number = heldBy(robot).or(() -> nearest(hand, GRASP_REACH)).orElse(null);
    Box box = boxes.get(number == null ? 0 : number);
    if (number == null || box == null) {
      return 0;
    }
    put(number, box.heldBy(robot));
    return box.kilograms();
  }

  /** A hand opens there. */
  synchronized void release(String robot, Vec2 hand) {
    heldBy(robot).ifPresent(number -> boxes.computeIfPresent(number, (_, b) -> b.lyingAt(hand)));
    write();
  }

  /** Robots lift what lies there, for a task. */
  synchronized void lift(long task, Vec2 middle) {
    if (heldBy(holder(task)).isEmpty()) {
      nearest(middle, LIFT_REACH)
          .ifPresent(
              number -> {
                Box box = boxes.get(number);
                if (box != null) {
                  put(number, box.heldBy(holder(task)));
                }
              });
    }
  }

  /** They set it down there. */
  synchronized void setDown(long task, Vec2 middle) {
    release(holder(task), middle);
  }

  private static String holder(long task) {
    return "task " + task;
  }

  private Optional<Integer> heldBy(String who) {
    return boxes.entrySet().stream()
        .filter(box -> who.equals(box.getValue().holder()))
        .map(Map.Entry::getKey)
        .findFirst();
  }

  private Optional<Integer> nearest(Vec2 point, double reach) {
    return lying().entrySet().stream()
        .filter(box -> box.getValue().distanceTo(point) <= reach)
        .min(Comparator.comparingDouble(box -> box.getValue().distanceTo(point)))
        .map(Map.Entry::getKey);
  }

  private void put(int number, Box box) {
    boxes.put(number, box);
    write();
  }

  private void write() {
    if (file == null) {
      return;
    }
    List<String> lines = new ArrayList<>();
    boxes.forEach(
        (number, box) ->
            lines.add(
                "%d %s %s %s %s"
                    .formatted(
                        number,
                        box.kilograms(),
                        box.place().x(),
                        box.place().y(),
                        box.holder() == null ? NOBODY : box.holder())));
    Path fresh = file.resolveSibling(file.getFileName() + ".new");
    try {
      Files.write(fresh, lines);
      try {
        Files.move(
            fresh, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
      } catch (AtomicMoveNotSupportedException e) {
        Files.move(fresh, file, StandardCopyOption.REPLACE_EXISTING);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
