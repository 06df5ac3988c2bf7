package org.toqa.endtoend;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;
import org.toqa.testbed.FaultyTcpProxy;
import org.toqa.testbed.RealMySql;

/**
 * A server on a real MySQL with one simulated robot, and two robots whose daemons are processes of
 * their own. All of it can be killed, and each connection be cut.
 */
final class CrashTestbed implements AutoCloseable {
  /** As the lab, with racks, narrow doors and ways a third as long: most of a run was driving. */
  static final String FLOOR = "hall";

  private static final double SPEED = 25;

  /**
   * Low: each must charge after a task or two, for most of a minute. What wheels slip leaves a
   * robot that has nothing but its odometry within a few centimetres until then, as clearances
   * allow for; with 0.002 it is 0.1 to 0.4 m off after 60 m, and bodies touch that nobody can know
   * of.
   */
  private static final String BATTERY =
      """
      battery: 0.21
      noise: 0.0003
      chargers: [{x: 7.35, y: 2.55}, {x: 7.35, y: 1.65}]
      """;

  /** Lives in the server's process. */
  private static final String SIMULATED = "r1";

  final FaultyTcpProxy database;
  final List<RunningAgent> agents;
  final Map<String, FaultyTcpProxy> links = new LinkedHashMap<>();
  final RunningServer server;
  private final SiteTruth truth;

  CrashTestbed(Path folder) throws Exception {
    String url = RealMySql.newDatabase();
    database = FaultyTcpProxy.toDatabase(url);
    Path config = folder.resolve("server.yaml");
    Files.writeString(
        config,
        """
        database:
          url: "%s"
        charging:
          below: 20
          until: 22
        simulateBatteries: 21
        """
            .formatted(database.through(url)));
    agents =
        List.of(
            new RunningAgent(folder, "carl", 5.55, 0.75, SPEED, BATTERY),
            new RunningAgent(folder, "dora", 6.15, 0.75, SPEED, BATTERY));
    server =
        new RunningServer(
            folder,
            "--config",
            config.toString(),
            "--map",
            map(),
            "--simulate",
            "1",
            "--speed",
            String.valueOf(SPEED));
    // else one drives where another stands that the server does not know yet
    server.awaitAccepted("fleet/pause", Map.of());
    for (RunningAgent agent : agents) {
      FaultyTcpProxy link = new FaultyTcpProxy(agent.port());
      links.put(agent.name(), link);
      server
          .api()
          .post(
              "robots",
              Map.of("name", agent.name(), "host", "127.0.0.1", "port", link.port(), "maxLoad", 5));
    }
    server.await("robots", robots -> robots.size() == 3);
    awaitRobots();
    server.awaitAccepted("fleet/resume", Map.of());
    Map<String, Path> bodies = new LinkedHashMap<>();
    bodies.put(SIMULATED, folder.resolve("data/robots/" + SIMULATED));
    agents.forEach(agent -> bodies.put(agent.name(), agent.data()));
    truth = new SiteTruth(bodies);
  }

  private static String map() throws URISyntaxException {
    return Path.of(Objects.requireNonNull(CrashTestbed.class.getResource(FLOOR + ".yaml")).toURI())
        .toString();
  }

  /** Their names. */
  List<String> robots() {
    return Stream.concat(Stream.of(SIMULATED), agents.stream().map(RunningAgent::name)).toList();
  }

  SiteTruth truth() {
    return truth;
  }

  /** Until all robots are heard. */
  void awaitRobots() throws Exception {
    server.await(
        "robots",
        robots ->
            robots
                .valueStream()
                .map(robot -> robot.get("state").asString())
                .noneMatch(List.of("LOST", "CONNECTING")::contains));
  }

  void restoreConnections() {
    database.mend();
    links.values().forEach(FaultyTcpProxy::mend);
  }

  /** Everything that server and robots have said; they are killed for it. */
  List<String> errorOutput() throws Exception {
    server.kill();
    List<String> lines = new ArrayList<>(server.errorOutput());
    for (RunningAgent agent : agents) {
      agent.kill();
      lines.addAll(agent.errorOutput());
    }
    return lines;
  }

  @Override
  public void close() throws IOException {
    truth.close();
    server.close();
    agents.forEach(RunningAgent::close);
    for (FaultyTcpProxy cable :
        Stream.concat(links.values().stream(), Stream.of(database)).toList()) {
      cable.close();
    }
  }
}
