package org.toqa.app.server;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.classic.spi.ThrowableProxyUtil;
import ch.qos.logback.core.AppenderBase;
import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.logging.Handler;
import java.util.logging.LogManager;
import java.util.logging.LogRecord;
import org.slf4j.LoggerFactory;

/**
 * Everything that is logged in this process, by whom ever, and what is printed; as the server is
 * shipped, whatever other tests of this process have set.
 */
final class LogRecording implements AutoCloseable {
  private final Queue<String> lines = new ConcurrentLinkedQueue<>();
  private final ByteArrayOutputStream printed = new ByteArrayOutputStream();
  private final PrintStream out = System.out;
  private final PrintStream err = System.err;
  private final Logger root = (Logger) LoggerFactory.getLogger(org.slf4j.Logger.ROOT_LOGGER_NAME);
  private final Level levelBefore = root.getLevel();
  private final java.util.logging.Logger julRoot = LogManager.getLogManager().getLogger("");

  private final AppenderBase<ILoggingEvent> appender =
      new AppenderBase<>() {
        @Override
        protected void append(ILoggingEvent event) {
          String stack =
              event.getThrowableProxy() == null
                  ? ""
                  : ThrowableProxyUtil.asString(event.getThrowableProxy());
          lines.add(event.getThreadName() + " " + event.getFormattedMessage() + " " + stack);
        }
      };

  private final Handler handler =
      new Handler() {
        @Override
        public void publish(LogRecord line) {
          lines.add(
              line.getMessage()
                  + " "
                  + List.of(line.getParameters() == null ? new Object[0] : line.getParameters())
                  + " "
                  + line.getThrown());
        }

        @Override
        public void flush() {}

        @Override
        public void close() {}
      };

  static LogRecording start() {
    LogRecording recording = new LogRecording();
    recording.appender.setContext(recording.root.getLoggerContext());
    recording.appender.start();
    recording.root.addAppender(recording.appender);
    recording.root.setLevel(Level.INFO);
    recording.julRoot.addHandler(recording.handler);
    System.setOut(recording.copying(recording.out));
    System.setErr(recording.copying(recording.err));
    return recording;
  }

  private PrintStream copying(PrintStream original) {
    return new PrintStream(
        new OutputStream() {
          @Override
          public void write(int b) {
            original.write(b);
            printed.write(b);
          }
        },
        true,
        StandardCharsets.UTF_8);
  }

  List<String> lines() {
    return List.copyOf(lines);
  }

  /** All of it. */
  String text() {
    return String.join("\n", lines) + "\n" + printed.toString(StandardCharsets.UTF_8);
  }

  @Override
  public void close() {
    System.setOut(out);
    System.setErr(err);
    root.detachAppender(appender);
    root.setLevel(levelBefore);
    julRoot.removeHandler(handler);
  }
}
