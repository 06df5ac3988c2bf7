package org.toqa.text;

import ch.qos.logback.classic.pattern.ClassicConverter;
import ch.qos.logback.classic.spi.ILoggingEvent;

/** What is logged, as one line, whoever wrote parts of it; {@code logback.xml} names it. */
public final class CleanMessageConverter extends ClassicConverter {
  /** Longer than any line of this program's own. */
  private static final int LONGEST = 4_000;

  @Override
  public String convert(ILoggingEvent event) {
    return CleanText.of(event.getFormattedMessage(), LONGEST);
  }
}
