package org.toqa.app;

import java.net.URI;
import java.nio.file.Path;

/** What is done while the whole product runs in this process. */
@FunctionalInterface
interface Operation {

  /**
   * @param address where the web pages are
   * @param stop the wish to end early
   * @return the exit code
   */
  int run(Toqa toqa, URI address, StopSignal stop) throws Exception;

  /**
   * Starts the product, does this, and closes everything in order: no request meets a closed fleet,
   * and no robot is touched by a server whose port is another's.
   */
  default int runOn(Configuration configuration, Path webapp, StopSignal stop) throws Exception {
    Logging.set(configuration.logLevel(), configuration.logFormat());
    Logging.adoptTomcat();
    try (WebServer web = WebServer.bind(webapp, configuration);
        Toqa toqa = Toqa.start(configuration);
        WebServer.Site site = web.open(toqa)) {
      return run(toqa, site.uri(), stop);
    }
  }
}
