package org.toqa.app.bench;

import java.net.URI;
import java.time.Duration;
import java.util.EnumMap;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.Arguments;
import org.toqa.app.config.Setting;
import org.toqa.app.server.ServerOperation;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import tools.jackson.databind.json.JsonMapper;

/** {@code toqa bench tasks}: how fast tasks can be put in, and whether all of them are there. */
@Command(
    name = "tasks",
    description = "Puts tasks into a whole server through its API, by many clients at once.",
    footer = {
      "",
      "Prints JSON: p50Ms, p99Ms and maxMs of POST /api/v1/tasks when the server has",
      "warmed up, tasksPerSecond,",
      "lost and twice (tasks that were accepted and are not there, or more than once;",
      "it exits 1), and heapMb (what is still in use when all are queued, clients",
      "included)."
    })
public final class TaskBench implements Callable<Integer> {
  private static final String USER = "bench";

  @Spec private CommandSpec spec = CommandSpec.create();

  @Option(
      names = "--tasks",
      defaultValue = "10000",
      paramLabel = "N",
      description = "How many, 1 to 100000 (default: ${DEFAULT-VALUE}).")
  private int tasks;

  @Option(
      names = "--warm-up",
      defaultValue = "1000",
      paramLabel = "N",
      description =
          "How many are put in before, and not timed, 0 to 100000 (default: ${DEFAULT-VALUE}).")
  private int warmUp;

  @Option(
      names = "--clients",
      defaultValue = "20",
      paramLabel = "N",
      description = "How many put them in at once, 1 to 1000 (default: ${DEFAULT-VALUE}).")
  private int clients;

  @Option(
      names = "--robots",
      defaultValue = "3",
      paramLabel = "N",
      description = "How many robots carry meanwhile, 0 to 500 (default: ${DEFAULT-VALUE}).")
  private int robots;

  @Option(
      names = "--database",
      paramLabel = "URL",
      description = "JDBC, of an empty database (default: an H2 file).")
  private @Nullable String database;

  @Override
  public Integer call() throws Exception {
    Arguments arguments = new Arguments(spec);
    arguments.requireBetween("--tasks", tasks, 1, 100_000);
    arguments.requireBetween("--warm-up", warmUp, 0, 100_000);
    arguments.requireBetween("--clients", clients, 1, 1000);
    arguments.requireBetween("--robots", robots, 0, 500);
    String password = UUID.randomUUID().toString();
    ServerOperation measurement = (toqa, address, stop) -> measure(address, password);
    return measurement.runIsolated(settings(password));
  }

  private int measure(URI address, String password) throws Exception {
    try (TaskApiClients apiClients = TaskApiClients.logIn(address, USER, password, clients)) {
      apiClients.submit(warmUp);
      long begun = System.nanoTime();
      double[] millis = apiClients.submit(tasks);
      Duration took = Duration.ofNanos(System.nanoTime() - begun);
      TaskReport report = TaskReport.of(millis, warmUp, took, clients, apiClients.taskNames());
      spec.commandLine().getOut().println(JsonMapper.shared().writeValueAsString(report));
      return report.lost() == 0 && report.twice() == 0 ? ExitCode.OK : ExitCode.SOFTWARE;
    }
  }

  private Map<Setting, @Nullable String> settings(String password) {
    Map<Setting, @Nullable String> settings = new EnumMap<>(Setting.class);
    settings.put(Setting.SIMULATE, String.valueOf(robots));
    settings.put(Setting.DATABASE_URL, database);
    settings.put(Setting.MANAGER, USER + ":" + password);
    return settings;
  }
}
