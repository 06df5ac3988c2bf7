package org.toqa.fleet;

/** How far an order is; the last two are its ends. */
public enum OrderState {
  /** No robot has worked for it yet. */
  QUEUED,
  IN_PROGRESS,
  /** What is left of it waits for a person. */
  STOPPED,
  /** All of it was carried. */
  DONE,
  /** It has ended, and not all of it was carried. */
  CANCELLED;

  public boolean isEnded() {
    return this == DONE || this == CANCELLED;
  }
}
