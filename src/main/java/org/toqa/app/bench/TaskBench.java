package org.toqa.app.bench;

import java.net.URI;
import java.time.Duration;
import java.util.EnumMap;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.Arguments;
import org.toqa.app.config.Setting;
import org.toqa.app.server.ServerOperation;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code toqa bench tasks}: how fast tasks can be put in, and whether all of them are there. */
@Command(
    name = "tasks",
    description = "Measure how fast a server accepts tasks through its API.",
    footer = {
      "",
      "Prints JSON: tasksPerSecond; p50Ms, p99Ms and maxMs (response times of",
      "POST /api/v1/tasks); lost and twice (tasks that were accepted and are missing,",
      "or stored more than once; exits 1 if there are any); heapMb (memory in use",
      "when all tasks are queued, including the clients)."
    })
final class TaskBench implements Callable<Integer> {
  @Spec private CommandSpec spec = CommandSpec.create();

  @Mixin private SimulatedRobotsOption robots = new SimulatedRobotsOption(3, 0);

  @Option(
      names = "--warm-up",
      defaultValue = "1000",
      paramLabel = "N",
      description =
          "Number of tasks before those that are measured, 0 to 100000 (default:"
              + " ${DEFAULT-VALUE}).")
  private int warmUp;

  @Mixin private TaskCountOption tasks = new TaskCountOption(10_000);

  @Option(
      names = "--clients",
      defaultValue = "20",
      paramLabel = "N",
      description = "Number of concurrent clients, 1 to 1000 (default: ${DEFAULT-VALUE}).")
  private int clients;

  @Mixin private DatabaseOption database = new DatabaseOption();

  @Override
  public Integer call() throws Exception {
    Arguments arguments = new Arguments(spec);
    tasks.check(arguments);
    database.check(arguments);
    arguments.requireBetween("--warm-up", warmUp, 0, 100_000);
    arguments.requireBetween("--clients", clients, 1, 1000);
    robots.check(arguments);
    BenchUser user = BenchUser.create();
    ServerOperation measurement = (toqa, address, stop) -> measure(address, user);
    return measurement.runIsolated(settings(user));
  }

  private int measure(URI address, BenchUser user) throws Exception {
    try (TaskApiClients apiClients = TaskApiClients.logIn(address, user, clients)) {
      apiClients.submit(warmUp);
      long begun = System.nanoTime();
      double[] millis = apiClients.submit(tasks.value());
      Duration took = Duration.ofNanos(System.nanoTime() - begun);
      TaskReport report = TaskReport.of(millis, warmUp, took, clients, apiClients.taskNames());
      new BenchOutput(spec).printReport(report);
      return report.lost() == 0 && report.twice() == 0 ? ExitCode.OK : ExitCode.SOFTWARE;
    }
  }

  private Map<Setting, @Nullable String> settings(BenchUser user) {
    Map<Setting, @Nullable String> settings = new EnumMap<>(Setting.class);
    settings.put(Setting.SIMULATE, String.valueOf(robots.value()));
    settings.put(Setting.DATABASE_URL, database.value());
    settings.put(Setting.MANAGER, user.setting());
    return settings;
  }
}
