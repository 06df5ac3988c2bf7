package org.toqa.fleet;

/**
 * A resume that is being stored: it acts only then, and not at all where a hold has come meanwhile.
 * Confined to one agent.
 */
public final class PendingResume {
  private long lastNumber;
  private boolean pending;

  public boolean isPending() {
    return pending;
  }

  /**
   * A resume is handed to the store.
   *
   * @return for {@link #complete}
   */
  public long begin() {
    pending = true;
    return ++lastNumber;
  }

  /** A hold has come. */
  public void cancel() {
    pending = false;
  }

  /**
   * The resume of that number is stored.
   *
   * @return whether it may act
   */
  public boolean complete(long number) {
    boolean isValid = pending && number == lastNumber;
    pending &= !isValid;
    return isValid;
  }
}
