package org.toqa.notices;

import java.time.Instant;
import java.util.UUID;
import org.jspecify.annotations.Nullable;

/**
 * A condition that was told, once.
 *
 * @param id rises with every notice; 0: it is not stored yet
 * @param uid the same in all that is told of it, so that a receiver knows what it has already
 * @param endedAt null while the condition lasts
 */
public record Notice(
    long id, UUID uid, Condition condition, Instant begunAt, @Nullable Instant endedAt) {

  public boolean isOpen() {
    return endedAt == null;
  }

  Notice ended(Instant at) {
    return new Notice(id, uid, condition, begunAt, at);
  }
}
