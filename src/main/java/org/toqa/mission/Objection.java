package org.toqa.mission;

import org.jspecify.annotations.Nullable;

/**
 * Why a task cannot do now what a person wishes.
 *
 * @param needs what the person must say too, if that is what is missing
 */
public record Objection(String sentence, @Nullable Question needs) {
  static Objection because(String sentence) {
    return new Objection(sentence, null);
  }
}
