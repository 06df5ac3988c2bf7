package org.toqa.fleet;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.Policy;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.mission.LoadChoice;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Reply;
import org.toqa.mission.TaskState;
import org.toqa.motion.DriveKind;
import org.toqa.wording.Sentence;

/**
 * A fleet at work as text: after remarks ({@code #} and a blank) the map, cells of 1 m, a line a
 * row: {@code #} a wall, {@code .} free, a small letter a robot at its parking point (it carries 5
 * kg), a capital a station, a digit a charging point ({@code 1} is C1). Then what happens, one
 * after the other; {@code expect} waits until it is so.
 *
 * <pre>
 * charges below 5                   percent; 20 where nothing is said, for the whole scenario
 * charges after 2                   seconds of work; six hours where nothing is said
 * charges within 20                 seconds, or the charger does not work; ten minutes where nothing is said
 * a is 1.4 wide                     metres, for the whole scenario
 * a drives 0.1                      metres a second at most, for the whole scenario
 * a turns 0.5                       radians a second at most, for the whole scenario
 * a cannot go sideways              for the whole scenario
 * a carries 10                      kilograms; 5 where nothing is said, for the whole scenario
 * allocates zones                   also: contract-net; optimal where nothing is said
 * a has 18                          percent in its battery, from now on
 * task box A B 2                    kilograms
 * task late A B 2 within 5          seconds to its deadline; "expect late answered ..." looks at
 *                                   what the caller was told
 * refused box A B 8 no room         the order, with these words
 * cancel box                        also: cancel box here, cancel box back
 * answer box another robot
 * hold box                          also: hold a, hold all; resume ...
 * a never bids                      also: bids late, refuses awards, bids strangely, bids as usual
 * a breaks                          also: is mended, falls silent, speaks again, sticks, is let go, misses the end,
 *                                   loses its followers, is pushed east
 * restart                           of the server
 * expect box CARRYING
 * expect box by a
 * expect box waits It needs 3 robots
 * expect box late The deadline cannot be met
 * expect box asks
 * expect box said r2 has not answered   in a negotiation about it
 * expect box told r1 must charge    in its history
 * expect a does Charges at C1
 * expect a is IDLE
 * expect a has 18
 * expect a at A
 * expect C1 fails                   also: works
 * </pre>
 */
final class FleetScenario {
  /** What is expected is seen a few steps later; nothing is to be over by then. */
  private static final int STEPS_A_SEGMENT = 5;

  private static final Pattern TASK =
      Pattern.compile("task (\\w+) ([A-Z]) ([A-Z]) ([0-9.]+)(?: within (\\d+))?");
  private static final Pattern REFUSED =
      Pattern.compile("refused (\\w+) ([A-Z]) ([A-Z]) ([0-9.]+) (.+)");
  private static final Pattern EXPECT = Pattern.compile("expect (\\w+) (\\S+) ?(.*)");
  private static final Pattern HAS = Pattern.compile("([a-z]) has (\\d+)");
  private static final Pattern ROBOT = Pattern.compile("([a-z]) (\\D+)");
  private static final Pattern CHARGES = Pattern.compile("charges (below|after|within) (\\d+)");
  private static final Pattern WIDE = Pattern.compile("([a-z]) is ([0-9.]+) wide");
  private static final Pattern DRIVES = Pattern.compile("([a-z]) drives ([0-9.]+)");
  private static final Pattern TURNS = Pattern.compile("([a-z]) turns ([0-9.]+)");
  private static final Pattern SIDEWAYS = Pattern.compile("([a-z]) cannot go sideways");
  private static final Pattern CARRIES = Pattern.compile("([a-z]) carries ([0-9.]+)");
  private static final Pattern ALLOCATES = Pattern.compile("allocates (\\S+)");
  private static final Pattern CANCEL = Pattern.compile("cancel (\\w+) ?(here|back)?");
  private static final Pattern HOLD = Pattern.compile("(hold|resume) (\\w+)");
  private static final Pattern ANSWER = Pattern.compile("answer (\\w+) (.+)");

  private final List<String> rows = new ArrayList<>();
  private final List<String> script = new ArrayList<>();
  private final Map<String, Double> diameters = new HashMap<>();
  private final Map<String, Double> maxSpeeds = new HashMap<>();
  private final Map<String, Double> maxTurnRates = new HashMap<>();
  private final Map<String, Double> maxLoads = new HashMap<>();
  private final Set<String> differential = new HashSet<>();
  private Policy policy = Policy.OPTIMAL;
  private ChargingRules charging = ChargingRules.USUAL;
  private final Map<String, Long> tasks = new HashMap<>();
  private final Map<String, TaskView> answered = new HashMap<>();
  private int digest;

  FleetScenario(String text) {
    for (String line : text.lines().toList()) {
      Matcher threshold = CHARGES.matcher(line);
      Matcher wide = WIDE.matcher(line);
      Matcher drives = DRIVES.matcher(line);
      Matcher turns = TURNS.matcher(line);
      Matcher carries = CARRIES.matcher(line);
      Matcher sideways = SIDEWAYS.matcher(line);
      Matcher allocates = ALLOCATES.matcher(line);
      if (threshold.matches()) {
        charging = chargingRules(threshold.group(1), Integer.parseInt(threshold.group(2)));
      } else if (wide.matches()) {
        diameters.put(wide.group(1), Double.parseDouble(wide.group(2)));
      } else if (drives.matches()) {
        maxSpeeds.put(drives.group(1), Double.parseDouble(drives.group(2)));
      } else if (carries.matches()) {
        maxLoads.put(carries.group(1), Double.parseDouble(carries.group(2)));
      } else if (sideways.matches()) {
        differential.add(sideways.group(1));
      } else if (allocates.matches()) {
        policy = Policy.ofWord(allocates.group(1)).orElseThrow();
      } else if (turns.matches()) {
        maxTurnRates.put(turns.group(1), Double.parseDouble(turns.group(2)));
      } else if (!line.isBlank() && !line.startsWith("# ")) {
        (line.contains(" ") || line.equals("restart") ? script : rows).add(line);
      }
    }
  }

  private static ChargingRules chargingRules(String when, int number) {
    ChargingRules usual = ChargingRules.USUAL;
    return new ChargingRules(
        when.equals("below") ? number / 100.0 : usual.below(),
        usual.until(),
        when.equals("after") ? Duration.ofSeconds(number) : usual.work(),
        usual.toFull(),
        when.equals("within") ? Duration.ofSeconds(number) : usual.patience());
  }

  /**
   * Plays it.
   *
   * @return the first line that did not come true, and what was so instead; null if all did
   */
  @Nullable String fault() throws Exception {
    try (FleetStage stage = new FleetStage(floor(), charging, policy)) {
      for (Place place : places('a', 'z')) {
        double maxLoad = maxLoads.getOrDefault(place.name(), ScriptedRobot.MAX_LOAD);
        ScriptedRobot robot =
            stage.add(place.name(), place.position(), "P" + place.name(), null, maxLoad);
        robot.setStepsPerSegment(STEPS_A_SEGMENT);
        robot.setFootprint(diameters.getOrDefault(place.name(), ScriptedRobot.FOOTPRINT));
        robot.setKind(
            differential.contains(place.name()) ? DriveKind.DIFFERENTIAL : DriveKind.OMNI);
        robot.setMaxTurnRate(maxTurnRates.getOrDefault(place.name(), ScriptedRobot.MAX_TURN_RATE));
        robot.setMaxSpeed(maxSpeeds.getOrDefault(place.name(), ScriptedRobot.MAX_SPEED));
      }
      stage.restart();
      stage.await(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
      for (String line : script) {
        stage.awaitQuiescence();
        if (!play(stage, line)) {
          return line + "\nIt is still so: " + stage.fleet.snapshots().latest();
        }
      }
      digest = stage.digest();
      return null;
    }
  }

  /** After it was played: of all that was to be seen meanwhile. */
  int digest() {
    return digest;
  }

  private boolean play(FleetStage stage, String line) throws Exception {
    Matcher expect = EXPECT.matcher(line);
    Matcher task = TASK.matcher(line);
    Matcher refused = REFUSED.matcher(line);
    Matcher cancel = CANCEL.matcher(line);
    Matcher answer = ANSWER.matcher(line);
    Matcher hold = HOLD.matcher(line);
    Matcher has = HAS.matcher(line);
    Matcher robot = ROBOT.matcher(line);
    if (expect.matches()) {
      return stage.becomesTrue(condition(stage, expect.group(1), expect.group(2), expect.group(3)));
    } else if (task.matches()) {
      submit(stage, task);
    } else if (refused.matches()) {
      return stage
                  .fleet
                  .submit(order(refused, null), "Clara")
                  .toCompletableFuture()
                  .get(10, TimeUnit.SECONDS)
              instanceof Answer.Rejected<TaskView>(String _, Sentence why)
          && contains(why, refused.group(5));
    } else if (cancel.matches()) {
      LoadChoice choice =
          cancel.group(2) == null
              ? null
              : LoadChoice.valueOf(cancel.group(2).toUpperCase(Locale.ROOT));
      accepted(
          stage.fleet.commandTask(id(cancel.group(1)), new MissionEvent.Cancel("Max", choice)));
    } else if (answer.matches()) {
      Reply reply = Reply.ofWord(answer.group(2)).orElseThrow();
      accepted(stage.fleet.commandTask(id(answer.group(1)), new MissionEvent.Answer("Max", reply)));
    } else if (hold.matches()) {
      hold(stage.fleet, hold.group(1).equals("hold"), hold.group(2));
    } else if (has.matches()) {
      stage.scriptedRobot(has.group(1)).setBattery(Integer.parseInt(has.group(2)) / 100.0);
    } else if (line.equals("restart")) {
      stage.restart();
    } else if (robot.matches()) {
      apply(stage, robot.group(1), robot.group(2));
    } else {
      throw new IllegalArgumentException("What is \"" + line + "\"?");
    }
    return true;
  }

  private void hold(Fleet fleet, boolean isHeld, String what) throws Exception {
    if (what.equals("all")) {
      accepted(isHeld ? fleet.pauseAll("Max") : fleet.resumeAll("Max"));
    } else if (tasks.containsKey(what)) {
      accepted(
          fleet.commandTask(
              id(what), isHeld ? new MissionEvent.Hold("Max") : new MissionEvent.Resume("Max")));
    } else {
      accepted(isHeld ? fleet.holdRobot(what, "Max") : fleet.resumeRobot(what, "Max"));
    }
  }

  private static void apply(FleetStage stage, String name, String what) {
    ScriptedRobot robot = stage.scriptedRobot(name);
    switch (what) {
      case "never bids" -> stage.setBidding(name, StrangeBidder.Habit.SILENT);
      case "bids late" -> stage.setBidding(name, StrangeBidder.Habit.LATE);
      case "refuses awards" -> stage.setBidding(name, StrangeBidder.Habit.REFUSES);
      case "bids strangely" -> stage.setBidding(name, StrangeBidder.Habit.STRANGE);
      case "bids as usual" -> stage.setBidding(name, StrangeBidder.Habit.USUAL);
      case "breaks" -> robot.breakDown("BUMPER");
      case "is mended" -> robot.repair();
      case "falls silent" -> robot.fallSilent();
      case "speaks again" -> robot.speakAgain();
      case "sticks" -> robot.setStuck(true);
      case "is let go" -> robot.setStuck(false);
      case "misses the end" -> robot.missEnd();
      case "loses its followers" -> robot.loseFollowers();
      case "is pushed east" -> robot.shove(new Vec2(3, 0));
      default -> throw new IllegalArgumentException("What is \"" + what + "\"?");
    }
  }

  private void submit(FleetStage stage, Matcher task) throws Exception {
    Instant deadline =
        task.group(5) == null
            ? null
            : stage.now.plus(Duration.ofSeconds(Long.parseLong(task.group(5))));
    TaskOrder order = order(task, deadline);
    TaskView view = accepted(stage.fleet.submit(order, "Clara"));
    tasks.put(order.name(), view.id());
    answered.put(order.name(), view);
  }

  private static TaskOrder order(Matcher task, @Nullable Instant deadline) {
    return new TaskOrder(
        task.group(1),
        Double.parseDouble(task.group(4)),
        new Where.Station(task.group(2)),
        new Where.Station(task.group(3)),
        null,
        0,
        deadline,
        null);
  }

  private Predicate<FleetSnapshot> condition(
      FleetStage stage, String who, String what, String words) {
    return switch (what) {
      case "by" -> view -> task(view, who).robots().equals(List.of(words.split(" ")));
      case "waits" -> view -> contains(task(view, who).waitingFor(), words);
      case "late" -> view -> contains(task(view, who).late(), words);
      case "asks" -> view -> task(view, who).needs() != null;
      case "answered" -> view -> contains(Objects.requireNonNull(answered.get(who)).late(), words);
      case "told" ->
          view -> stage.store.history(id(who)).stream().anyMatch(e -> e.text().contains(words));
      case "said" ->
          view ->
              view.negotiations().getOrDefault(id(who), List.of()).stream()
                  .anyMatch(line -> contains(line.text(), words));
      case "has" ->
          view ->
              Objects.equals(
                  robot(view, who).telemetry().battery(), Integer.parseInt(words) / 100.0);
      case "does" -> view -> contains(robot(view, who).work().doing(), words);
      case "fails" -> view -> isFaulty(view, who);
      case "works" -> view -> !isFaulty(view, who);
      case "is" -> view -> robot(view, who).state() == RobotState.valueOf(words);
      case "at" ->
          view -> stage.scriptedRobot(who).position().distanceTo(position(words.charAt(0))) < 1e-6;
      default -> view -> task(view, who).state() == TaskState.valueOf(what);
    };
  }

  private static boolean isFaulty(FleetSnapshot view, String charger) {
    return view.floors().getFirst().faultyChargers().stream()
        .anyMatch(faulty -> faulty.name().equals(charger));
  }

  private static boolean contains(@Nullable Sentence sentence, String words) {
    return sentence != null && sentence.english().contains(words);
  }

  private long id(String task) {
    return Objects.requireNonNull(tasks.get(task), task);
  }

  private TaskView task(FleetSnapshot view, String name) {
    return view.tasks().stream()
        .filter(t -> t.id() == id(name))
        .findFirst()
        .orElse(Objects.requireNonNull(answered.get(name)));
  }

  private static RobotView robot(FleetSnapshot view, String name) {
    return view.robots().stream().filter(r -> r.name().equals(name)).findFirst().orElseThrow();
  }

  private static <T> T accepted(CompletionStage<Answer<T>> pending) throws Exception {
    Answer<T> answer = pending.toCompletableFuture().get(10, TimeUnit.SECONDS);
    if (answer instanceof Answer.Accepted<T>(T value)) {
      return value;
    }
    throw new IllegalArgumentException("No: " + answer);
  }

  // --- the floor --------------------------------------------------------------------------------

  private FloorMap floor() {
    OccupancyGrid grid =
        OccupancyGrid.parse(
            rows.stream().map(row -> row.replaceAll("[^#]", ".")).toArray(String[]::new));
    List<Place> parking =
        places('a', 'z').stream().map(p -> new Place("P" + p.name(), p.position())).toList();
    List<Place> charging =
        places('0', '9').stream().map(p -> new Place("C" + p.name(), p.position())).toList();
    return new FloorMap("hall", grid, places('A', 'Z'), parking, charging);
  }

  private List<Place> places(char from, char to) {
    List<Place> places = new ArrayList<>();
    for (char name = from; name <= to; name++) {
      if (String.join("", rows).indexOf(name) >= 0) {
        places.add(new Place(String.valueOf(name), position(name)));
      }
    }
    return places;
  }

  private Vec2 position(char name) {
    for (int row = 0; row < rows.size(); row++) {
      int column = rows.get(row).indexOf(name);
      if (column >= 0) {
        return new Vec2(column + 0.5, rows.size() - row - 0.5);
      }
    }
    throw new IllegalArgumentException("There is no " + name + " on the map.");
  }
}
