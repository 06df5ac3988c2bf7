package org.toqa.text;

import ch.qos.logback.classic.pattern.ThrowableProxyConverter;
import ch.qos.logback.classic.spi.IThrowableProxy;
import java.util.stream.Collectors;

/**
 * A stack trace whose lines are indented, so that none of them, whoever wrote the message of the
 * exception, looks like a line of the log; {@code logback.xml} names it.
 */
public final class CleanStackTraceConverter extends ThrowableProxyConverter {
  private static final String INDENT = "  ";
  private static final int LONGEST = 1_000;

  @Override
  protected String throwableProxyToString(IThrowableProxy thrown) {
    return super.throwableProxyToString(thrown)
        .lines()
        .map(line -> INDENT + CleanText.of(line, LONGEST) + System.lineSeparator())
        .collect(Collectors.joining());
  }
}
