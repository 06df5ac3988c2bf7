package org.toqa.link;

import org.toqa.wording.Sentence;

/** Why a connection was not made or has ended; the message is a sentence for people. */
final class LinkException extends Exception {
  private static final long serialVersionUID = 1;

  private final transient Sentence sentence;
  private final boolean trustFailure;

  LinkException(Sentence sentence) {
    this(sentence, false);
  }

  private LinkException(Sentence sentence, boolean refusal) {
    super(sentence.english());
    this.sentence = sentence;
    this.trustFailure = refusal;
  }

  /** One end does not trust the other, or is not the one that it should be: somebody must come. */
  static LinkException trustFailure(Sentence sentence) {
    return new LinkException(sentence, true);
  }

  Sentence sentence() {
    return sentence;
  }

  boolean isTrustFailure() {
    return trustFailure;
  }
}
