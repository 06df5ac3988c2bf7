package org.toqa.mission;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * What a person must decide, and the words to answer it with.
 *
 * @param robot that cannot go on; null where it is about none
 * @param why a clause about that robot, such as {@code is not heard of}
 * @param place where that robot is; null where nobody knows
 */
public record Question(
    Kind kind,
    Sentence question,
    List<String> answers,
    @Nullable String robot,
    @Nullable Sentence why,
    @Nullable String place) {

  public enum Kind {
    /** A robot is in trouble before it has the load. */
    NOT_FETCHED,
    /** A robot is in trouble with the load on board. */
    ON_BOARD,
    /** The same, and nobody knows where. */
    ON_BOARD_SOMEWHERE,
    /** An arm did not pick the load up, or put it down. */
    NOT_HANDLED,
    /** Where the load of a cancelled task goes. */
    SET_DOWN
  }

  public Question {
    answers = List.copyOf(answers);
  }

  /** Kilograms, where an arm did not lift the load since it has weighed that it is too heavy. */
  public Optional<Double> weighed() {
    return why != null
            && why.phrase() == Phrase.ARM_TOO_WEAK
            && why.values().getFirst() instanceof Number kilograms
        ? Optional.of(kilograms.doubleValue())
        : Optional.empty();
  }

  static Question about(Trouble trouble, Kind kind, Sentence question, List<String> answers) {
    TaskPlace place = trouble.place();
    return new Question(
        kind,
        question,
        answers,
        trouble.robot(),
        trouble.why(),
        place == null ? null : place.text());
  }
}
