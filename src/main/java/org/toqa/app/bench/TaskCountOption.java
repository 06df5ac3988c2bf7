package org.toqa.app.bench;

import org.toqa.app.command.Arguments;
import picocli.CommandLine.Option;

/** {@code --tasks}: how many tasks a bench measures. */
final class TaskCountOption {
  private static final int MAX_TASKS = 100_000;

  @Option(
      names = "--tasks",
      paramLabel = "N",
      description = "Number of tasks, 1 to " + MAX_TASKS + " (default: ${DEFAULT-VALUE}).")
  private int tasks;

  /**
   * @param defaultTasks where the option is not given
   */
  TaskCountOption(int defaultTasks) {
    tasks = defaultTasks;
  }

  /**
   * @throws picocli.CommandLine.ParameterException when it is out of its range
   */
  void check(Arguments arguments) {
    arguments.requireBetween("--tasks", tasks, 1, MAX_TASKS);
  }

  int value() {
    return tasks;
  }
}
