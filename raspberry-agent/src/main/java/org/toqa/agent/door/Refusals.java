package org.toqa.agent.door;

import java.net.InetAddress;
import java.time.Duration;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.message.AgentMessage.Fault;

/** Who was not let in of late, for the log and for the robot's server. */
final class Refusals {

  private static final Logger log = LoggerFactory.getLogger(Refusals.class);

  /** So long a refusal is told to the server. */
  private static final Duration TOLD = Duration.ofMinutes(1);

  private final String robot;
  private final LongSupplier nanos;
  private @Nullable String last;
  private long lastNanos;

  /**
   * @param nanos what time it is, on a monotonic clock
   */
  Refusals(String robot, LongSupplier nanos) {
    this.robot = robot;
    this.nanos = nanos;
  }

  /**
   * @param sentence with one place for the address
   */
  synchronized void note(String sentence, InetAddress from) {
    String text = sentence.replace("%s", from.getHostAddress());
    if (!text.equals(last) || isOver()) { // a flood is logged once
      log.warn("{}: {}", robot, text);
    }
    last = text;
    lastNanos = nanos.getAsLong();
  }

  /** The last refusal, if it is not long ago. */
  synchronized Optional<Fault> fault() {
    return last == null || isOver() ? Optional.empty() : Optional.of(new Fault("REFUSED", last));
  }

  private boolean isOver() {
    return nanos.getAsLong() - lastNanos > TOLD.toNanos();
  }
}
