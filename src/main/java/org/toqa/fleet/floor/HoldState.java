package org.toqa.fleet.floor;

import java.time.Instant;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.toqa.wording.Sentence;

/**
 * Whether a robot shall hold, and what it was told of that. Only {@link HoldDispatcher} changes it.
 */
final class HoldState {
  private @Nullable Sentence reason;
  private Instruction instruction = Instruction.NONE;
  private Instant lastHeld = Instant.MIN;

  /**
   * What the robot was told last on this connection.
   *
   * @param hold whether it shall hold; else it goes on
   */
  record Instruction(boolean hold, Instant at) {
    static final Instruction NONE = new Instruction(false, Instant.MIN);
  }

  /** Why it shall hold; null: it need not. */
  @Nullable Sentence reason() {
    return reason;
  }

  boolean isHeld() {
    return reason != null;
  }

  Instruction instruction() {
    return instruction;
  }

  /** When it last was to hold. */
  Instant lastHeld() {
    return lastHeld;
  }

  /**
   * @return whether that is new
   */
  boolean setReason(@Nullable Sentence next, Instant now) {
    boolean isNew = !Objects.equals(next, reason);
    reason = next;
    if (next != null) {
      lastHeld = now;
    }
    return isNew;
  }

  void setInstruction(Instruction told) {
    instruction = told;
  }
}
