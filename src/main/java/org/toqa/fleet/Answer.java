package org.toqa.fleet;

import org.jspecify.annotations.Nullable;
import org.toqa.mission.Objection;
import org.toqa.mission.Question;
import org.toqa.wording.Sentence;

/** What the fleet answers to an order or a command: done and stored, or refused in a sentence. */
public sealed interface Answer<T> {

  record Accepted<T>(T value) implements Answer<T> {}

  /**
   * @param field the field of the order that is at fault, if it is one
   * @param sentence what is wrong and what to do, for a person
   */
  record Rejected<T>(@Nullable String field, Sentence sentence) implements Answer<T> {}

  /**
   * It cannot be done in the present state.
   *
   * @param needs what a person must say too, if that is what is missing
   */
  record Conflict<T>(Sentence sentence, @Nullable Question needs) implements Answer<T> {}

  /** It was changed since the caller read it; nothing was done. */
  record Outdated<T>() implements Answer<T> {}

  /** Nothing of that name or number exists. */
  record Unknown<T>(Sentence sentence) implements Answer<T> {}

  static <T> Answer<T> conflict(Objection objection) {
    return new Conflict<>(objection.sentence(), objection.needs());
  }

  /** This "no", for a caller that expects another kind of value. */
  default <R> Answer<R> asRejection() {
    return switch (this) {
      case Accepted<T> accepted -> throw new IllegalStateException("Accepted: " + accepted);
      case Rejected<T>(String field, Sentence sentence) -> new Rejected<>(field, sentence);
      case Conflict<T>(Sentence sentence, Question needs) -> new Conflict<>(sentence, needs);
      case Outdated<T>() -> new Outdated<>();
      case Unknown<T>(Sentence sentence) -> new Unknown<>(sentence);
    };
  }
}
