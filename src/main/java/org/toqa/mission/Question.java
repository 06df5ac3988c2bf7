package org.toqa.mission;

import java.util.List;

/** What a person must decide, and the words to answer it with. */
public record Question(String question, List<String> answers) {
  public Question {
    answers = List.copyOf(answers);
  }
}
