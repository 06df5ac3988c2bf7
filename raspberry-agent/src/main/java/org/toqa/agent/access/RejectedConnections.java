package org.toqa.agent.access;

import java.net.InetAddress;
import java.time.Duration;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.message.AgentMessage.Fault;

/** Whose connections were rejected of late, for the log and for the robot's server. */
final class RejectedConnections {

  private static final Logger log = LoggerFactory.getLogger(RejectedConnections.class);

  /** So long a rejection is reported to the server. */
  private static final Duration REPORT_DURATION = Duration.ofMinutes(1);

  private final String robot;
  private final LongSupplier nanos;
  private @Nullable String last;
  private long lastNanos;

  /**
   * @param nanos what time it is, on a monotonic clock
   */
  RejectedConnections(String robot, LongSupplier nanos) {
    this.robot = robot;
    this.nanos = nanos;
  }

  /**
   * @param sentence with one place for the address
   */
  synchronized void record(String sentence, InetAddress from) {
    String text = sentence.replace("%s", from.getHostAddress());
    if (!text.equals(last) || isExpired()) { // a flood is logged once
      log.warn("{}: {}", robot, text);
    }
    last = text;
    lastNanos = nanos.getAsLong();
  }

  /** The last refusal, if it is not long ago. */
  synchronized Optional<Fault> fault() {
    return last == null || isExpired() ? Optional.empty() : Optional.of(new Fault("REFUSED", last));
  }

  private boolean isExpired() {
    return nanos.getAsLong() - lastNanos > REPORT_DURATION.toNanos();
  }
}
