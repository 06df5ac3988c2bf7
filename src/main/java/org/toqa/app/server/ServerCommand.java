package org.toqa.app.server;

import java.net.URI;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.app.command.OptionalMapOption;
import org.toqa.app.command.PortOption;
import org.toqa.app.command.SpeedOption;
import org.toqa.app.command.StopSignal;
import org.toqa.app.config.Configuration;
import org.toqa.app.config.ConfigurationException;
import org.toqa.app.config.Setting;
import org.toqa.app.config.SettingSource;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code toqa server}: for real use, until it is told to end. */
@Command(
    name = "server",
    description = "Run the server, with real or simulated robots, until Ctrl-C.",
    footer = {
      "",
      "Settings can be given on the command line, in the environment (such as",
      "TOQA_PORT) and in the file, in this order of precedence. See",
      "docs/configuration.md for all settings."
    })
public final class ServerCommand implements Callable<Integer> {

  private static final Logger log = LoggerFactory.getLogger(ServerCommand.class);

  @Option(names = "--config", paramLabel = "FILE", description = "Read settings from a YAML file.")
  private @Nullable Path config;

  @Mixin private PortOption port = new PortOption();

  @Option(
      names = "--data",
      paramLabel = "DIR",
      description = "Folder for the server's data (default: toqa-data).")
  private @Nullable String data;

  @Mixin private OptionalMapOption map = new OptionalMapOption();

  @Option(
      names = "--simulate",
      paramLabel = "N",
      description = "Number of simulated robots, 0 to 500 (default: 0).")
  private @Nullable String simulate;

  @Mixin private SpeedOption speed = new SpeedOption();

  @Override
  public Integer call() throws Exception {
    Path webapp = WebappFolder.path();
    Configuration configuration = Configuration.of(WebappFolder.shippedMap(), settingSources());
    ServerOperation untilStopped = ServerCommand::awaitStop;
    try (StopSignal stop = new StopSignal()) {
      Thread.setDefaultUncaughtExceptionHandler((thread, e) -> reportUncaught(thread, e, stop));
      return untilStopped.runWith(configuration, webapp, stop);
    }
  }

  /** A thread that runs out of memory is not made up for. */
  private static void reportUncaught(Thread thread, Throwable e, StopSignal stop) {
    if (e instanceof VirtualMachineError) {
      stop.fail("The thread " + thread.getName() + " has ended by " + e);
    }
    log.error("{} has ended.", thread.getName(), e);
  }

  private static int awaitStop(FleetServer toqa, URI address, StopSignal stop)
      throws InterruptedException {
    System.err.println("Toqa is at " + address + " (Ctrl-C ends it)");
    stop.await();
    return 0;
  }

  private List<SettingSource> settingSources() throws ConfigurationException {
    Map<Setting, @Nullable String> options = new EnumMap<>(Setting.class);
    options.put(Setting.PORT, port.value());
    options.put(Setting.DATA, data);
    options.put(Setting.MAP, map.file());
    options.put(Setting.SIMULATE, simulate);
    options.put(Setting.SPEED, speed.value());
    List<SettingSource> layers = new ArrayList<>();
    layers.add(SettingSource.fromCommandLine(options));
    layers.add(SettingSource.fromEnvironment(System.getenv()));
    Path file = config == null ? environmentFile() : config;
    if (file != null) {
      layers.add(SettingSource.fromFile(file));
    }
    return layers;
  }

  private static @Nullable Path environmentFile() {
    String name = System.getenv(SettingSource.FILE_ENVIRONMENT_VARIABLE);
    return name == null || name.isEmpty() ? null : Path.of(name);
  }
}
