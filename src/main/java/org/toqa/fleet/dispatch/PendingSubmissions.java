package org.toqa.fleet.dispatch;

import java.util.Collection;
import java.util.HashSet;
import java.util.Set;
import java.util.UUID;

/**
 * The idempotency keys of tasks that are being stored, or withdrawn again: whether there will be a
 * task with such a key, nobody knows. Any thread may call it.
 */
public final class PendingSubmissions {
  private final Set<UUID> keys = new HashSet<>();

  /**
   * @return false when one of the keys is pending already; then none of them is added
   */
  synchronized boolean begin(Collection<UUID> added) {
    if (added.stream().anyMatch(keys::contains)) {
      return false;
    }
    keys.addAll(added);
    return true;
  }

  synchronized void end(Collection<UUID> decided) {
    keys.removeAll(decided);
  }

  public synchronized boolean contains(UUID key) {
    return keys.contains(key);
  }
}
