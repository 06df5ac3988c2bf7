package org.toqa.fleet.floor;

import java.time.Instant;
import java.util.Optional;

/** Whether a robot is heard. */
sealed interface Contact {
  record Heard() implements Contact {}

  /** Connected, but it says nothing. */
  record Silent(Instant since) implements Contact {}

  /**
   * @param since when it was not heard any more
   */
  record Disconnected(Instant since) implements Contact {}

  default boolean isConnected() {
    return !(this instanceof Disconnected);
  }

  /** Since when it is not heard; empty while it is. */
  default Optional<Instant> silentSince() {
    return switch (this) {
      case Heard ignored -> Optional.empty();
      case Silent silent -> Optional.of(silent.since());
      case Disconnected gone -> Optional.of(gone.since());
    };
  }

  /** The robot is connected, and says something. */
  default Contact heardAgain() {
    return isConnected() ? new Heard() : this;
  }

  default Contact fallenSilent(Instant now) {
    return this instanceof Heard ? new Silent(now) : this;
  }

  default Contact disconnected(Instant now) {
    return switch (this) {
      case Heard ignored -> new Disconnected(now);
      case Silent silent -> new Disconnected(silent.since());
      case Disconnected gone -> gone;
    };
  }
}
