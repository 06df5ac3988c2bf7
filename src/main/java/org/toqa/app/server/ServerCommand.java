package org.toqa.app.server;

import java.net.URI;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.StopSignal;
import org.toqa.app.config.Configuration;
import org.toqa.app.config.ConfigurationException;
import org.toqa.app.config.Setting;
import org.toqa.app.config.SettingSource;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code toqa server}: for real use, until it is told to end. */
@Command(
    name = "server",
    description = "Runs the server until Ctrl-C, with real or simulated robots.",
    footer = {
      "",
      "Each setting may also stand in the file or in the environment (TOQA_PORT).",
      "The command line comes first, then the environment, then the file;",
      "docs/configuration.md explains them all."
    })
public final class ServerCommand implements Callable<Integer> {

  @Option(names = "--config", paramLabel = "FILE", description = "A YAML file with settings.")
  private @Nullable Path config;

  @Option(
      names = "--port",
      paramLabel = "P",
      description = "Where the web pages are served, 0 for any free port (default: 8080).")
  private @Nullable String port;

  @Option(
      names = "--data",
      paramLabel = "DIR",
      description = "The folder for what the server keeps (default: toqa-data).")
  private @Nullable String data;

  @Option(
      names = "--map",
      paramLabel = "FILE",
      description = "The floor's map, .yaml or .map (default: the shipped map).")
  private @Nullable String map;

  @Option(names = "--simulate", paramLabel = "N", description = "Makes N simulated robots.")
  private @Nullable String simulate;

  @Option(
      names = "--speed",
      paramLabel = "N",
      description = "Lets the simulated robots live N times faster.")
  private @Nullable String speed;

  @Override
  public Integer call() throws Exception {
    Path webapp = WebappFolder.path();
    Configuration configuration = Configuration.of(webapp, settingSources());
    ServerOperation untilStopped = ServerCommand::awaitStop;
    try (StopSignal stop = new StopSignal()) {
      return untilStopped.runWith(configuration, webapp, stop);
    }
  }

  private static int awaitStop(FleetServer toqa, URI address, StopSignal stop)
      throws InterruptedException {
    System.err.println("Toqa is at " + address + " (Ctrl-C ends it)");
    stop.await();
    return 0;
  }

  private List<SettingSource> settingSources() throws ConfigurationException {
    Map<Setting, @Nullable String> options = new EnumMap<>(Setting.class);
    options.put(Setting.PORT, port);
    options.put(Setting.DATA, data);
    options.put(Setting.MAP, map);
    options.put(Setting.SIMULATE, simulate);
    options.put(Setting.SPEED, speed);
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
