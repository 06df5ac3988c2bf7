package org.toqa.app;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import org.slf4j.LoggerFactory;
import org.slf4j.bridge.SLF4JBridgeHandler;

/** The log: one stream on standard error, for this product and for the embedded server. */
final class Logging {
  private Logging() {}

  static void setLevel(Level level) {
    ((Logger) LoggerFactory.getLogger(org.slf4j.Logger.ROOT_LOGGER_NAME)).setLevel(level);
  }

  /** Brings Tomcat's lines into the same stream. Not for a stock Tomcat, which has its own. */
  static void adoptTomcat() {
    SLF4JBridgeHandler.removeHandlersForRootLogger();
    SLF4JBridgeHandler.install();
  }
}
