package org.toqa.agent.control;

import java.util.Optional;

/** What a command comes to when it is checked. */
sealed interface CommandCheck {
  /**
   * @param effect to be run once the journal has recorded the command
   */
  record Accepted(Runnable effect) implements CommandCheck {}

  record Refused(String reason) implements CommandCheck {}

  static CommandCheck of(Optional<String> objection, Runnable effect) {
    return objection.<CommandCheck>map(Refused::new).orElseGet(() -> new Accepted(effect));
  }
}
