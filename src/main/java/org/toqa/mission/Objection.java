package org.toqa.mission;

import org.jspecify.annotations.Nullable;
import org.toqa.wording.Sentence;

/**
 * Why a task cannot do now what an operator command asks.
 *
 * @param needs what the person must say too, if that is what is missing
 */
public record Objection(Sentence sentence, @Nullable Question needs) {
  static Objection of(Sentence sentence) {
    return new Objection(sentence, null);
  }
}
