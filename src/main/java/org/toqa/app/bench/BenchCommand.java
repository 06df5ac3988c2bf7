package org.toqa.app.bench;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code toqa bench}: the measurements. */
@Command(
    name = "bench",
    description = "Measure the planners, a daemon and a complete server; prints JSON.",
    subcommands = {
      ScenarioBench.class,
      TrafficBench.class,
      MapfBench.class,
      SmoothBench.class,
      FloorBench.class,
      FleetBench.class,
      SoakBench.class,
      TaskBench.class,
      WebBench.class,
      SmoothnessBench.class,
      StartupBench.class,
      DaemonBench.class,
      HttpBench.class,
      AllocationBench.class,
      FormationBench.class
    })
public final class BenchCommand implements Runnable {
  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public void run() {
    throw new ParameterException(spec.commandLine(), "What to measure is missing");
  }
}
