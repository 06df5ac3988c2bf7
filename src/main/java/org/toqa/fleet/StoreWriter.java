package org.toqa.fleet;

import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.WaitingChanges.Change;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;

/**
 * Writes the changes of one agent to the store, in order, and tells when each is safe, on a thread
 * of the {@link GroupCommitter} that it is of.
 */
public final class StoreWriter {
  private final String name;
  private final WaitingChanges waiting;
  private final GroupCommitter committer;

  StoreWriter(String name, WaitingChanges waiting, GroupCommitter committer) {
    this.name = name;
    this.waiting = waiting;
    this.committer = committer;
  }

  /**
   * @param change calls of the store, and nothing else: it may be repeated
   * @param stored called once the change is safe
   */
  public void write(Runnable change, Runnable stored) {
    write(change, stored, refusal -> {});
  }

  /**
   * @param change calls of the store, and nothing else: it may be repeated
   * @param stored called once the change is safe
   * @param refused called instead when it can never be stored
   */
  public void write(Runnable change, Runnable stored, Consumer<StoreException> refused) {
    waiting.add(new Change(name, null, false, change, stored, refused));
  }

  /**
   * Writes what is of interest only until the next one comes: one that still waits then is left out
   * without a word, and this one is stored in its place.
   *
   * @param subject what is told by it
   */
  public void writeNewest(String subject, Runnable change, Runnable stored) {
    waiting.add(new Change(name, subject, false, change, stored, refusal -> {}));
  }

  /** Writes a line of the history, which is left out where very many changes wait. */
  public void writeLine(Runnable change) {
    if (waiting.isFull()) {
      committer.tellLeftOut(Phrase.LINES_LEFT_OUT.with(name));
    } else {
      write(change, () -> {});
    }
  }

  /**
   * Tries a change once, alone; for orders whose caller waits for the answer.
   *
   * @param failed gets the reason when it could not be stored
   */
  public void tryOnce(Runnable change, Runnable stored, Consumer<StoreException> failed) {
    waiting.add(new Change(name, null, true, change, stored, failed));
  }

  /** Why the store does not answer, or null while it does. */
  @Nullable
  public String trouble() {
    return committer.trouble();
  }
}
