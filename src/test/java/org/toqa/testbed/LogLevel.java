package org.toqa.testbed;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import org.slf4j.LoggerFactory;

/**
 * What a logger tells while this is open, whatever other tests of this process have set for all.
 */
public final class LogLevel implements AutoCloseable {
  private final Logger log;

  /** Only errors: a refused line is worth a warning, a million are not. */
  public static LogLevel errors(String logger) {
    return new LogLevel(logger, Level.ERROR);
  }

  /** As the server is shipped. */
  public static LogLevel usual(String logger) {
    return new LogLevel(logger, Level.INFO);
  }

  private LogLevel(String logger, Level level) {
    log = (Logger) LoggerFactory.getLogger(logger);
    log.setLevel(level);
  }

  @Override
  public void close() {
    log.setLevel(null);
  }
}
