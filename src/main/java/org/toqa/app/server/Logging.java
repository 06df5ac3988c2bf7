package org.toqa.app.server;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.encoder.JsonEncoder;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.OutputStreamAppender;
import org.slf4j.LoggerFactory;
import org.slf4j.bridge.SLF4JBridgeHandler;
import org.toqa.app.config.Configuration.LogFormat;

/** The log: one stream on standard error, for this product and for the embedded server. */
public final class Logging {
  private Logging() {}

  static void configure(Level level, LogFormat format) {
    Logger root = root();
    root.setLevel(level);
    if (format == LogFormat.JSON) {
      root.iteratorForAppenders()
          .forEachRemaining(
              appender -> {
                if (appender instanceof OutputStreamAppender<ILoggingEvent> stream) {
                  stream.setEncoder(jsonEncoder(root));
                }
              });
    }
  }

  /** How much is logged. */
  static String level() {
    return root().getLevel().toString();
  }

  /**
   * @param level a level's name
   */
  public static void changeLevel(String level) {
    root().setLevel(Level.valueOf(level));
  }

  private static Logger root() {
    return (Logger) LoggerFactory.getLogger(org.slf4j.Logger.ROOT_LOGGER_NAME);
  }

  /** Each line a JSON object. */
  private static JsonEncoder jsonEncoder(Logger root) {
    JsonEncoder encoder = new JsonEncoder();
    encoder.setContext(root.getLoggerContext());
    encoder.setWithContext(false);
    encoder.setWithSequenceNumber(false);
    encoder.setWithNanoseconds(false);
    encoder.setWithMessage(false);
    encoder.setWithArguments(false);
    encoder.setWithFormattedMessage(true);
    encoder.start();
    return encoder;
  }

  /** Brings Tomcat's lines into the same stream. Not for a stock Tomcat, which has its own. */
  static void redirectTomcatLog() {
    SLF4JBridgeHandler.removeHandlersForRootLogger();
    SLF4JBridgeHandler.install();
  }
}
