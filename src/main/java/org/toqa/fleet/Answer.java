package org.toqa.fleet;

import org.jspecify.annotations.Nullable;

/** What the fleet answers to a wish: done and stored, or refused in a sentence. */
public sealed interface Answer<T> {

  record Accepted<T>(T value) implements Answer<T> {}

  /**
   * @param field the field of the order that is at fault, if it is one
   * @param sentence what is wrong and what to do, for a person
   */
  record Refused<T>(@Nullable String field, String sentence) implements Answer<T> {}

  /** Nothing of that name or number exists. */
  record Unknown<T>(String sentence) implements Answer<T> {}

  /** This "no", for an asker who wanted another kind of value. */
  default <R> Answer<R> refusal() {
    return switch (this) {
      case Accepted<T> accepted -> throw new IllegalStateException("Accepted: " + accepted);
      case Refused<T>(String field, String sentence) -> new Refused<>(field, sentence);
      case Unknown<T>(String sentence) -> new Unknown<>(sentence);
    };
  }
}
