package org.toqa.endtoend;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.random.RandomGenerator;

/**
 * Something that people want of the fleet at a {@link CrashTestbed}.
 *
 * @param number 0 to 9; picks one of the tasks or robots that there are then, or says how heavy
 */
record Work(Kind kind, String start, String goal, int number) {
  /** With room for two robots round a load. */
  private static final List<String> STATIONS =
      List.of("Goods-in 1", "Mill", "Test bench", "Assembly", "Packing 1", "Goods-out");

  private static final Map<String, Object> IN_A_WALL = Map.of("x", 0.05, "y", 0.05);

  enum Kind {
    DELIVERY("deliveries"),
    TEAM_DELIVERY("deliveries by teams"),
    IMPOSSIBLE_DELIVERY("refused deliveries"),
    CANCEL("cancelled tasks"),
    IMPORT("imports"),
    FAULTY_IMPORT("refused imports"),
    SCHEDULE("schedules"),
    TASK_HOLD("holds of tasks"),
    ROBOT_HOLD("holds of robots"),
    FLOOR_HOLD("holds of the floor"),
    PAUSE("pauses"),
    PUBLICATION("published maps");

    private final String plural;

    Kind(String plural) {
      this.plural = plural;
    }

    String plural() {
      return plural;
    }

    /** Whether something stands still until people let it go on. */
    boolean isHold() {
      return this == TASK_HOLD || this == ROBOT_HOLD || this == FLOOR_HOLD || this == PAUSE;
    }
  }

  static Work random(Kind kind, RandomGenerator random) {
    int start = random.nextInt(STATIONS.size());
    int goal = (start + 1 + random.nextInt(STATIONS.size() - 1)) % STATIONS.size();
    return new Work(kind, STATIONS.get(start), STATIONS.get(goal), random.nextInt(10));
  }

  /** Of one load. */
  Map<String, Object> order(String name) {
    return Map.of(
        "name",
        name,
        "load",
        kilograms(),
        "start",
        Map.of("station", start),
        "goal",
        kind == Kind.IMPOSSIBLE_DELIVERY ? IN_A_WALL : Map.of("station", goal));
  }

  /** A table of so many loads; the last one of a faulty import goes into a wall. */
  String table(String name, int lines) {
    StringBuilder table = new StringBuilder("name,load,start,goal,goalX,goalY\n");
    for (int i = 0; i < lines; i++) {
      String where =
          kind == Kind.FAULTY_IMPORT && i == lines - 1
              ? "," + IN_A_WALL.get("x") + "," + IN_A_WALL.get("y")
              : goal + ",,";
      table.append(name).append(i).append(",1,").append(start).append(',').append(where);
      table.append('\n');
    }
    return table.toString();
  }

  /** A robot carries 5 kg. */
  private int kilograms() {
    return switch (kind) {
      case TEAM_DELIVERY -> 6 + number % 5; // two robots; there is not everywhere room for three
      default -> 1 + number % 5;
    };
  }

  @Override
  public String toString() {
    return kind.name().toLowerCase(Locale.ROOT).replace('_', ' ');
  }
}
