package org.toqa.app.server;

import java.net.URI;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.StopSignal;
import org.toqa.app.command.TemporaryFolder;
import org.toqa.app.config.Configuration;
import org.toqa.app.config.Setting;
import org.toqa.app.config.SettingSource;

/** What a command does while the complete server runs in this process. */
@FunctionalInterface
public interface ServerOperation {
  /** What one user at one address needs more of than people do. */
  List<Setting> UNLIMITED =
      List.of(
          Setting.REQUESTS_AT_ONCE,
          Setting.CHECKS_PER_USER,
          Setting.STREAMS_PER_USER,
          Setting.STREAMS_PER_ADDRESS,
          Setting.CONNECTIONS_PER_ADDRESS);

  /** The most that each of them may be. */
  String MUCH = "10000";

  /**
   * @param address where the web pages are, with a slash at its end
   * @param stop the request to end early
   * @return the exit code of the process
   * @throws Exception it failed; the message says why, for a person
   */
  int run(FleetServer toqa, URI address, StopSignal stop) throws Exception;

  /**
   * Does this with a server of its own: with its data in a folder that is deleted afterwards, on
   * any free port, without limits of requests, and with nothing in the log but errors.
   *
   * @param settings those that differ from the defaults
   * @return the exit code of the process
   * @throws org.toqa.app.config.ConfigurationException a setting cannot be used
   * @throws Exception the server cannot start, or the operation failed; the message says why
   */
  default int runIsolated(Map<Setting, @Nullable String> settings) throws Exception {
    Path webapp = WebappFolder.path();
    try (StopSignal stop = new StopSignal();
        TemporaryFolder data = TemporaryFolder.create("toqa-bench")) {
      Map<Setting, @Nullable String> all = new EnumMap<>(settings);
      all.put(Setting.DATA, data.path().toString());
      all.put(Setting.PORT, "0");
      all.put(Setting.REQUESTS_PER_SECOND, "0");
      UNLIMITED.forEach(setting -> all.put(setting, MUCH));
      all.put(Setting.LOG_LEVEL, "ERROR");
      List<SettingSource> layers = List.of(SettingSource.fromCommandLine(all));
      return runWith(Configuration.of(WebappFolder.shippedMap(), layers), webapp, stop);
    }
  }

  /**
   * Starts the server, does this, and closes everything in order: no request meets a closed fleet,
   * and a server that cannot have its port connects to no robot. Where a part fails without which
   * the server cannot go on, the operation is asked to stop and the exit code is 1.
   *
   * @param folder that of the unpacked web application
   * @return the exit code of the process
   * @throws Exception the server cannot start, or the operation failed; the message says why
   */
  default int runWith(Configuration configuration, Path folder, StopSignal stop) throws Exception {
    Logging.configure(configuration.logLevel(), configuration.logFormat());
    Logging.redirectTomcatLog();
    try (WebServer web = WebServer.bind(folder, configuration);
        SiteServers sites = SiteServers.start(configuration);
        WebServer.RunningWebapp webapp = web.open(sites)) {
      FleetServer toqa = sites.firstServer();
      var _ = toqa.whenFailed().thenAccept(stop::fail);
      int code = run(toqa, webapp.uri(), stop);
      return stop.hasFailed() ? 1 : code;
    }
  }
}
