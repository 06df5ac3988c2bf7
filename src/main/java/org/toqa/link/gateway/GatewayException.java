package org.toqa.link.gateway;

import org.toqa.link.message.GatewayMessage;

/** Why a robot cannot be reached through a gateway. */
public final class GatewayException extends Exception {
  private static final long serialVersionUID = 1;

  /** What is in the way. */
  public enum Reason {
    /** The server's configuration names no such gateway. */
    UNKNOWN_GATEWAY,
    /** The gateway is not connected, or its connection has ended. */
    GATEWAY_NOT_CONNECTED,
    NOT_ALLOWED,
    HOST_NOT_KNOWN,
    DOES_NOT_ANSWER,
    CANNOT_BE_REACHED,
    TOO_MANY_LINKS
  }

  private final Reason reason;

  GatewayException(Reason reason, String text) {
    super(text);
    this.reason = reason;
  }

  static GatewayException of(GatewayMessage.NotOpened answer) {
    return new GatewayException(Reason.valueOf(answer.reason().name()), answer.text());
  }

  public Reason reason() {
    return reason;
  }
}
