package org.toqa.link.http;

import java.io.IOException;
import org.jspecify.annotations.Nullable;

/** Why a robot did not answer as it should; the message says more, for a log or a person. */
public final class HttpRobotException extends IOException {
  private static final long serialVersionUID = 1;

  /** What is the matter. */
  public enum Reason {
    /** Nothing in the network has that name. */
    HOST_NOT_KNOWN,
    /** The host is there, and nobody listens. */
    NOBODY_LISTENS,
    /** The time for an answer is over. */
    DOES_NOT_ANSWER,
    /** There is no way to the host, or the connection broke. */
    CANNOT_BE_REACHED,
    /** It does not take the token (401 or 403). */
    WRONG_TOKEN,
    /** It shows another certificate than the one that is known. */
    ANOTHER_CERTIFICATE,
    /** It answers with another status than 200. */
    REFUSES,
    /** Its answer is not one of these messages, or too long. */
    NONSENSE
  }

  private final Reason reason;

  HttpRobotException(Reason reason, String message, @Nullable Throwable cause) {
    super(message, cause);
    this.reason = reason;
  }

  HttpRobotException(Reason reason, String message) {
    this(reason, message, null);
  }

  public Reason reason() {
    return reason;
  }

  /** Whether only a person can mend it: one end does not trust the other. */
  public boolean isTrustFailure() {
    return reason == Reason.WRONG_TOKEN || reason == Reason.ANOTHER_CERTIFICATE;
  }
}
