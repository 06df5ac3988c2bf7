package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;

/**
 * A floor, its robots and what happens to them, as text. After remarks ({@code #} and a blank) and
 * settings comes the map, a line a row: {@code #} a wall, {@code .} free, a small letter a robot.
 * What follows names places by column and row of the map as drawn:
 *
 * <pre>
 * cell 0.4              metres along a drawn cell's side
 * fine 6                a drawn cell is 6 x 6 cells of the grid
 * size a 0.5            diameter, metres; 0.255 where nothing is said
 * speed a 0.1           metres a second at most; 0.25 where nothing is said
 * a to 8,1              where it wants to go at the start
 * at 20 a to 3,1        ... and after 20 s
 * at 20 a stops         its wheels are stopped, nobody knows why
 * at 30 a drives        ... and turn again
 * at 20 a is lost       it cannot be told anything any more
 * at 30 a is found
 * at 20 a leaves
 * at 20 b joins at 2,2
 * at 20 obstacle at 4,1
 * at 60 clear           of obstacles
 * within 300            seconds
 * expect a arrives
 * expect b waits: Waiting for a
 * cycle a b             at some time they wait for each other, and at the end no longer
 * </pre>
 */
final class FloorScenario {
  private final List<String> rows = new ArrayList<>();
  private final Map<String, Double> sizes = new TreeMap<>();
  private final Map<String, Double> speeds = new TreeMap<>();
  private final Map<Double, List<String[]>> events = new TreeMap<>();
  private final Map<String, String> expected = new LinkedHashMap<>();
  private final Set<Set<String>> cyclesExpected = new HashSet<>();
  private double cell = DrivenFloor.CELL;
  private int fine = 1;
  private double limit = 300;

  FloorScenario(String text) {
    for (String line : text.lines().toList()) {
      if (!line.isBlank() && !line.startsWith("# ")) {
        read(line);
      }
    }
  }

  private void read(String line) {
    String[] words = line.strip().split(" +");
    switch (words[0]) {
      case "cell" -> cell = Double.parseDouble(words[1]);
      case "fine" -> fine = Integer.parseInt(words[1]);
      case "size" -> sizes.put(words[1], Double.parseDouble(words[2]));
      case "speed" -> speeds.put(words[1], Double.parseDouble(words[2]));
      case "cycle" -> cyclesExpected.add(Set.of(tail(words, 1)));
      case "within" -> limit = Double.parseDouble(words[1]);
      case "expect" -> expected.put(words[1], line.substring(line.indexOf(words[2])));
      case "at" -> happens(Double.parseDouble(words[1]), tail(words, 2));
      default -> {
        if (words.length == 1) {
          rows.add(line.strip());
        } else {
          happens(0, words);
        }
      }
    }
  }

  private void happens(double seconds, String[] words) {
    events.computeIfAbsent(seconds, s -> new ArrayList<>()).add(words);
  }

  private static String[] tail(String[] words, int from) {
    return Arrays.copyOfRange(words, from, words.length);
  }

  /**
   * Drives it.
   *
   * @return what did not come as expected, empty if all did
   */
  List<String> faults(long seed) {
    DrivenFloor floor = new DrivenFloor(grid(), seed);
    for (int row = 0; row < rows.size(); row++) {
      for (int column = 0; column < rows.get(row).length(); column++) {
        char c = rows.get(row).charAt(column);
        if (Character.isLowerCase(c)) {
          join(floor, String.valueOf(c), column + "," + row);
        }
      }
    }
    Set<Set<String>> cyclesSeen = new HashSet<>();
    List<Double> times = new ArrayList<>(events.keySet());
    for (int step = 0; step < limit * 10 && !(times.isEmpty() && isAsExpected(floor)); step++) {
      while (!times.isEmpty() && times.getFirst() <= step / 10.0) {
        events.getOrDefault(times.removeFirst(), List.of()).forEach(e -> happen(floor, e));
      }
      floor.step();
      cyclesSeen.addAll(cycles(floor));
    }
    List<String> faults = new ArrayList<>();
    if (!cyclesSeen.containsAll(cyclesExpected)) {
      faults.add("of the cycles " + cyclesExpected + " there were only " + cyclesSeen);
    }
    if (!cyclesExpected.isEmpty() && !cycles(floor).isEmpty()) {
      faults.add("at the end there still are " + cycles(floor));
    }
    expected.forEach(
        (robot, what) -> {
          if (!isAsExpected(floor, robot, what)) {
            faults.add(robot + " was to: " + what + "; it says: " + floor.reason(robot));
          }
        });
    return faults;
  }

  private static Set<Set<String>> cycles(DrivenFloor floor) {
    return floor.traffic.standstills().stream()
        .filter(standstill -> standstill.kind() == Standstill.Kind.CYCLE_OF_WAITS)
        .map(standstill -> Set.copyOf(standstill.robots()))
        .collect(Collectors.toSet());
  }

  private boolean isAsExpected(DrivenFloor floor) {
    return expected.entrySet().stream()
        .allMatch(e -> isAsExpected(floor, e.getKey(), e.getValue()));
  }

  private static boolean isAsExpected(DrivenFloor floor, String robot, String what) {
    return what.startsWith("waits: ")
        ? !floor.isArrived(robot) && floor.reason(robot).startsWith(what.substring(7))
        : floor.isArrived(robot);
  }

  private void happen(DrivenFloor floor, String[] words) {
    String robot = words[0];
    switch (words.length == 1 ? "" : words[1]) {
      case "to" -> floor.sendTo(robot, point(words[2]));
      case "stops" -> floor.body(robot).isStuck = true;
      case "drives" -> floor.body(robot).isStuck = false;
      case "is" -> {
        if (words[2].equals("lost")) {
          floor.lose(robot);
        } else {
          floor.find(robot);
        }
      }
      case "leaves" -> floor.remove(robot);
      case "joins" -> join(floor, robot, words[3]);
      case "at" -> floor.traffic.setObstacles(cells(words[2], floor.grid), Map.of());
      case "" -> floor.traffic.setObstacles(new BitSet(), Map.of());
      default -> throw new IllegalArgumentException("What is " + String.join(" ", words) + "?");
    }
  }

  private void join(DrivenFloor floor, String robot, String place) {
    floor.putAt(robot, point(place), sizes.getOrDefault(robot, DrivenFloor.DIAMETER));
    floor.setMaxSpeed(robot, speeds.getOrDefault(robot, DriveSpeeds.DEFAULT.forward()));
  }

  private OccupancyGrid grid() {
    int width = rows.getFirst().length() * fine;
    BitSet walls = new BitSet();
    for (int row = 0; row < rows.size() * fine; row++) {
      for (int column = 0; column < width; column++) {
        walls.set(row * width + column, rows.get(row / fine).charAt(column / fine) == '#');
      }
    }
    return new OccupancyGrid(width, rows.size() * fine, cell / fine, Vec2.ZERO, walls);
  }

  private Vec2 point(String place) {
    int comma = place.indexOf(',');
    double column = Double.parseDouble(place.substring(0, comma));
    double row = Double.parseDouble(place.substring(comma + 1));
    return new Vec2((column + 0.5) * cell, (rows.size() - row - 0.5) * cell);
  }

  private BitSet cells(String place, OccupancyGrid grid) {
    Cell middle = grid.cellAt(point(place));
    BitSet cells = new BitSet();
    cells.set(grid.index(middle));
    return cells;
  }
}
