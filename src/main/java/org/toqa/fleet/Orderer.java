package org.toqa.fleet;

import org.jspecify.annotations.Nullable;

/**
 * Who orders tasks, schedules or templates.
 *
 * @param name under which they are listed
 * @param account the id of the user whose they are: what comes when he may log in no more, or is no
 *     user any more, is not stored; null: whoever has the name, if anybody
 */
public record Orderer(String name, @Nullable Long account) {

  /** Somebody who need not be a user. */
  public static Orderer named(String name) {
    return new Orderer(name, null);
  }
}
