package org.toqa.link.gateway;

import java.time.Duration;
import java.util.HashSet;
import java.util.Set;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Says who was not let in: each address once a minute for each reason, and not more than a few. */
final class RejectedGateways {
  private static final Logger log = LoggerFactory.getLogger(RejectedGateways.class);

  private static final long PERIOD_NANOS = Duration.ofMinutes(1).toNanos();
  private static final int MOST_IN_PERIOD = 20;

  private final LongSupplier nanos;
  private final Set<String> logged = new HashSet<>();
  private long periodBegan;

  /**
   * @param nanos what time it is, on a monotonic clock
   */
  RejectedGateways(LongSupplier nanos) {
    this.nanos = nanos;
    this.periodBegan = nanos.getAsLong();
  }

  /** Whether it was worth a line. */
  synchronized boolean record(String address, String why) {
    long now = nanos.getAsLong();
    if (now - periodBegan >= PERIOD_NANOS) {
      periodBegan = now;
      logged.clear();
    }
    String line = address + ": " + why;
    boolean isNew = logged.size() < MOST_IN_PERIOD && logged.add(line);
    if (isNew) {
      log.warn("A connection to the port for gateways was ended; {}", line);
    }
    return isNew;
  }
}
