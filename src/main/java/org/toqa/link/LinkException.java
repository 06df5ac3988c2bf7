package org.toqa.link;

/** Why a connection was not made or has ended; the message is a sentence for people. */
final class LinkException extends Exception {
  private static final long serialVersionUID = 1;

  LinkException(String sentence) {
    super(sentence);
  }
}
