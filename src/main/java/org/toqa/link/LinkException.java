package org.toqa.link;

/** Why a connection was not made or has ended; the message is a sentence for people. */
final class LinkException extends Exception {
  private static final long serialVersionUID = 1;

  private final boolean refusal;

  LinkException(String sentence) {
    this(sentence, false);
  }

  private LinkException(String sentence, boolean refusal) {
    super(sentence);
    this.refusal = refusal;
  }

  /** One end does not trust the other. */
  static LinkException refusal(String sentence) {
    return new LinkException(sentence, true);
  }

  boolean isRefusal() {
    return refusal;
  }
}
