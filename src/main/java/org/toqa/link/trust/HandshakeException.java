package org.toqa.link.trust;

import java.io.IOException;

/** No encrypted connection to somebody trusted came about; the message is for logs. */
public final class HandshakeException extends IOException {
  private static final long serialVersionUID = 1;

  /** What went wrong. */
  public enum Reason {
    /** The other end has proved to be somebody who is not trusted. */
    UNTRUSTED_PEER,
    /** The other end does not trust this one. */
    REJECTED_BY_PEER,
    /** The other end does not speak TLS. */
    NOT_TLS,
    /** The connection ended in the middle. */
    CUT_OFF,
    /** It took too long. */
    TIMED_OUT,
    /** Anything else, such as another version of TLS. */
    FAILED
  }

  private final Reason reason;

  HandshakeException(Reason reason, String message, Throwable cause) {
    super(message, cause);
    this.reason = reason;
  }

  public Reason reason() {
    return reason;
  }
}
