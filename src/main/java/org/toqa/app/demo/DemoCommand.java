package org.toqa.app.demo;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.config.Avoidance;
import org.toqa.app.command.PortOption;
import org.toqa.app.command.SpeedOption;
import org.toqa.app.command.StopSignal;
import org.toqa.app.command.TemporaryFolder;
import org.toqa.app.config.Configuration;
import org.toqa.app.config.ConfigurationException;
import org.toqa.app.config.Setting;
import org.toqa.app.config.SettingSource;
import org.toqa.app.server.FleetServer;
import org.toqa.app.server.FleetServer.BodyObservation;
import org.toqa.app.server.ServerOperation;
import org.toqa.app.server.WebappFolder;
import org.toqa.fleet.TaskOrder;
import org.toqa.grid.FloorMap;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code toqa demo}: simulated robots carry out tasks, with everything on this machine. */
@Command(name = "demo", description = "Run a demo with simulated robots on this machine.")
public final class DemoCommand implements Callable<Integer> {
  private static final String USER = "demo";
  private static final String USUAL = "usual";
  private static final String BUILDING = "building";
  private static final String STORE = "store";
  private static final String YARD = "yard";

  /** Percent, robot by robot: the third one has to charge soon. */
  private static final String BATTERIES = "100,100,22,100";

  private static final String PASSWORD = "demo-robots";

  /** Set by the launcher, which builds the firmware. */
  private static final String FIRMWARE_FOLDER = "toqa.firmware";

  @Option(names = "--once", description = "Run the demo tasks, print a table of results, and exit.")
  private boolean once;

  @Option(
      names = "--robots",
      defaultValue = "3",
      paramLabel = "N",
      description =
          "Number of robots on the first floor, 1 to "
              + DemoTasks.MAX_ROBOTS
              + " (default: ${DEFAULT-VALUE}).")
  private int robots;

  @Option(
      names = "--firmware",
      description = "Run the first robot with the real firmware in a simulated microcontroller.")
  private boolean firmware;

  @Option(
      names = "--scenario",
      paramLabel = "NAME",
      description =
          "usual: simulated robots on four floors. building: one robot with two wheels on each of"
              + " three floors, over HTTP and MQTT. store: a supervisor with cameras and two workers"
              + " with arms carry ten boxes. yard: two robots find their own way among people through a"
              + " free zone (default: usual).")
  private String scenario = USUAL;

  @Option(
      names = "--sequential",
      description = "With --scenario store: look for boxes only while no worker carries one.")
  private boolean sequential;

  @Mixin private SpeedOption speed = new SpeedOption();

  @Mixin private PortOption port = new PortOption();

  @Option(
      names = "--report",
      paramLabel = "FILE",
      description = "Write the results of the demo tasks to FILE, as JSON.")
  private @Nullable Path report;

  @Option(
      names = "--bodies",
      paramLabel = "FILE",
      description =
          "Write where the simulated robots and the loads of groups really are to FILE, 50 times"
              + " per simulated second, as JSON lines.")
  private @Nullable Path bodies;

  private boolean isBuilding() {
    return scenario.equals(BUILDING);
  }

  private boolean isStore() {
    return scenario.equals(STORE);
  }

  private boolean isYard() {
    return scenario.equals(YARD);
  }

  @Override
  public Integer call() throws Exception {
    checkRobots();
    checkScenario();
    checkWritable("--report", report);
    checkWritable("--bodies", bodies);
    checkFirmware();
    Path webapp = WebappFolder.path();
    try (StopSignal stop = new StopSignal();
        TemporaryFolder data = TemporaryFolder.create("toqa-demo")) {
      Configuration configuration =
          Configuration.of(WebappFolder.shippedMap(), List.of(settings(data.path())));
      ServerOperation show = isBuilding() ? this::runBuilding : this::runRecorded;
      return show.runWith(configuration, webapp, stop);
    }
  }

  private int runBuilding(FleetServer toqa, URI address, StopSignal stop) throws Exception {
    try (BuildingScenario _ = BuildingScenario.begin(toqa, USER)) {
      return runDemo(toqa, address, stop);
    }
  }

  private int runRecorded(FleetServer toqa, URI address, StopSignal stop) throws Exception {
    if (bodies == null) {
      return runDemo(toqa, address, stop);
    }
    try (BodyRecorder recorder = BodyRecorder.create(bodies);
        FloorObservations observed = new FloorObservations()) {
      for (FloorMap floor : toqa.fleet().floors()) {
        observed.add(
            toqa.observeBodies(
                floor.name(), (at, there) -> recorder.write(at, floor.name(), there)));
      }
      return runDemo(toqa, address, stop);
    }
  }

  /** Those of all floors, which end together. */
  private static final class FloorObservations implements AutoCloseable {
    private final List<BodyObservation> observations = new ArrayList<>();

    void add(BodyObservation observation) {
      observations.add(observation);
    }

    @Override
    public void close() {
      observations.forEach(BodyObservation::close);
    }
  }

  private int runDemo(FleetServer toqa, URI address, StopSignal stop) throws Exception {
    System.err.println();
    System.err.println("  Toqa is at " + address);
    System.err.println("  Log in as " + USER + " with the password " + PASSWORD);
    System.err.println("  Ctrl-C ends everything; nothing is kept.");
    System.err.println();
    DemoTasks tasks = new DemoTasks(toqa.fleet(), toqa.fleetClock());
    if (isStore()) {
      return runStore(toqa, tasks, stop);
    }
    if (isYard()) {
      try (BodyObservation _ = YardScenario.begin(toqa)) {
        return runTasks(YardScenario.orders(), tasks, stop);
      }
    }
    return runTasks(
        isBuilding() ? BuildingScenario.orders() : DemoTasks.orders(robots), tasks, stop);
  }

  private int runTasks(List<TaskOrder> orders, DemoTasks tasks, StopSignal stop) throws Exception {
    tasks.submit(orders, USER);
    if (once) {
      boolean isDone = tasks.awaitEnd(stop, System.err::println);
      System.err.println();
      System.err.print(tasks.table());
      if (report != null) {
        Files.writeString(report, tasks.json());
      }
      return isDone ? ExitCode.OK : ExitCode.SOFTWARE;
    }
    tasks.awaitEnd(stop, System.err::println);
    stop.await();
    return 0;
  }

  private int runStore(FleetServer toqa, DemoTasks tasks, StopSignal stop) throws Exception {
    StoreScenario.begin(toqa, USER, !sequential);
    Instant begun = toqa.fleetClock().instant();
    tasks.awaitEnd(stop, System.err::println, () -> StoreScenario.isOver(toqa));
    System.err.println();
    System.err.print(tasks.table());
    System.err.print(
        StoreScenario.summary(toqa, Duration.between(begun, toqa.fleetClock().instant())));
    if (!once) {
      stop.await();
      return 0;
    }
    if (report != null) {
      Files.writeString(report, tasks.json());
    }
    return StoreScenario.isDone(toqa) ? ExitCode.OK : ExitCode.SOFTWARE;
  }

  private SettingSource settings(Path data) throws IOException {
    Map<Setting, @Nullable String> options = new EnumMap<>(Setting.class);
    if (isBuilding()) {
      options.put(Setting.MAP, BuildingScenario.maps(data.resolve("maps")));
      options.put(Setting.MQTT_BROKER, "embedded");
      options.put(Setting.MQTT_PORT, "0");
      options.put(Setting.MQTT_PLAIN, "true");
    } else if (isStore()) {
      options.put(Setting.MAP, StoreScenario.map(data.resolve("maps")));
      options.put(Setting.SIMULATE, StoreScenario.ROBOTS);
      options.put(Setting.SIMULATE_BATTERIES, StoreScenario.BATTERIES);
      options.put(Setting.CHARGING_UNTIL, StoreScenario.CHARGE_UNTIL);
      options.put(Setting.SIMULATE_BOXES, StoreScenario.boxes(data.resolve("maps")));
    } else if (isYard()) {
      options.put(Setting.MAP, YardScenario.map(data.resolve("maps")));
      options.put(Setting.SIMULATE, YardScenario.ROBOTS);
      options.put(Setting.SIMULATE_AVOIDANCE, Avoidance.FOUR_AGENTS.word());
    } else {
      options.put(Setting.MAP, WebappFolder.shippedMaps());
      options.put(Setting.SIMULATE, robots + "," + DemoTasks.ROBOTS_ELSEWHERE);
      options.put(Setting.SIMULATE_BATTERIES, BATTERIES);
    }
    options.put(Setting.MANAGER, USER + ":" + PASSWORD);
    if (!isStore()) {
      options.put(Setting.ALLOCATOR, "zones"); // by the load, as Tanta does
    }
    options.put(Setting.LOG_LEVEL, "WARN");
    options.put(Setting.DATA, data.toString());
    options.put(Setting.FIRMWARE, firmware ? System.getProperty(FIRMWARE_FOLDER) : null);
    options.put(Setting.SPEED, speed.value());
    options.put(Setting.PORT, port.value());
    return SettingSource.fromCommandLine(options);
  }

  private void checkRobots() throws ConfigurationException {
    if (robots < 1 || robots > DemoTasks.MAX_ROBOTS) {
      throw new ConfigurationException(
          "--robots \""
              + robots
              + "\": it must be a whole number from 1 to "
              + DemoTasks.MAX_ROBOTS
              + ".");
    }
  }

  /** Its robots are no part of the simulated world: they live by the machine's clock. */
  private void checkScenario() throws ConfigurationException {
    if (!scenario.equals(USUAL) && !isBuilding() && !isStore() && !isYard()) {
      throw new ConfigurationException(
          "--scenario \"" + scenario + "\": it must be usual, building, store or yard.");
    }
    if (sequential && !isStore()) {
      throw new ConfigurationException("--sequential goes with --scenario store only.");
    }
    if (isStore() && firmware) {
      throw new ConfigurationException(
          "--scenario store simulates arms together with the boxes that they take: it does not go"
              + " with --firmware.");
    }
    if (isYard() && firmware) {
      throw new ConfigurationException(
          "--scenario yard has robots with eight range sensors, which those of the firmware have"
              + " not: it does not go with --firmware.");
    }
    boolean isWithSimulation = speed.value() != null || firmware || bodies != null;
    if (isBuilding() && isWithSimulation) {
      throw new ConfigurationException(
          "--scenario building drives its robots over HTTP in real time: it goes with neither"
              + " --speed, --firmware nor --bodies.");
    }
  }

  private void checkFirmware() throws ConfigurationException {
    if (firmware && System.getProperty(FIRMWARE_FOLDER) == null) {
      throw new ConfigurationException(
          "--firmware needs the firmware built: start the demo by ./toqa demo --firmware.");
    }
  }

  private static void checkWritable(String option, @Nullable Path file)
      throws ConfigurationException {
    if (file == null) {
      return;
    }
    Path folder = file.toAbsolutePath().getParent();
    if (folder == null || !Files.isWritable(folder) || Files.isDirectory(file)) {
      throw new ConfigurationException(
          option + " \"" + file + "\": it must be a file in a folder that can be written.");
    }
  }
}
