package org.toqa.web;

/** The fleet did not answer in time, or its store failed. */
public final class FleetUnavailableException extends RuntimeException {
  public FleetUnavailableException(Throwable cause) {
    super("The fleet did not answer.", cause);
  }
}
