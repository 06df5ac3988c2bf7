package org.toqa.fleet;

import java.time.Duration;

/** An order or preview was not checked to its end. Nothing was stored; it may be sent again. */
public final class CheckRefusedException extends RuntimeException {
  private static final long serialVersionUID = 1;

  /** Why it was not. */
  public enum Reason {
    /** As many of the same user are being checked as one may have at once. */
    TOO_MANY(Duration.ofSeconds(1)),
    /** It took too long. */
    OUT_OF_TIME(Duration.ofSeconds(5));

    private final Duration pause;

    Reason(Duration pause) {
      this.pause = pause;
    }

    /** After which it makes sense to send it again. */
    public Duration pause() {
      return pause;
    }
  }

  private final Reason reason;

  public CheckRefusedException(Reason reason) {
    super("An order was not checked: " + reason, null, false, false);
    this.reason = reason;
  }

  public Reason reason() {
    return reason;
  }
}
