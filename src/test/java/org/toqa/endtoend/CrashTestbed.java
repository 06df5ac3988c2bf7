package org.toqa.endtoend;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.toqa.testbed.FaultyTcpProxy;
import org.toqa.testbed.RealMySql;

/**
 * A server on a real MySQL with one simulated robot, and two robots whose daemons are processes of
 * their own. All of it can be killed, and each connection be cut.
 */
final class CrashTestbed implements AutoCloseable {
  private static final double SPEED = 20;

  final FaultyTcpProxy database;
  final List<RunningAgent> agents;
  final Map<String, FaultyTcpProxy> links = new LinkedHashMap<>();
  final RunningServer server;

  CrashTestbed(Path folder) throws Exception {
    String url = RealMySql.newDatabase();
    database = FaultyTcpProxy.toDatabase(url);
    Path config = folder.resolve("server.yaml");
    Files.writeString(config, "database:\n  url: \"%s\"\n".formatted(database.through(url)));
    agents =
        List.of(
            new RunningAgent(folder, "carl", 7.95, 3.15, SPEED),
            new RunningAgent(folder, "dora", 15.15, 1.05, SPEED));
    server =
        new RunningServer(
            folder,
            "--config",
            config.toString(),
            "--simulate",
            "1",
            "--speed",
            String.valueOf(SPEED));
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
    server.close();
    agents.forEach(RunningAgent::close);
    for (FaultyTcpProxy cable :
        Stream.concat(links.values().stream(), Stream.of(database)).toList()) {
      cable.close();
    }
  }
}
