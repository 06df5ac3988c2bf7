package org.toqa.notices;

import org.jspecify.annotations.Nullable;
import org.toqa.wording.Sentence;

/**
 * Something that needs attention as long as it lasts.
 *
 * @param subject tells it from others of its kind; together they name it
 * @param task it is about, if any
 * @param robot it is about, if any
 * @param owner the id of the account of whose task it is about; null: of none
 */
public record Condition(
    NoticeKind kind,
    String subject,
    @Nullable String floor,
    @Nullable Long task,
    @Nullable String robot,
    @Nullable Long owner,
    Sentence text) {

  /** As long as the store keeps; a robot's codes of errors may be longer. */
  private static final int LONGEST_SUBJECT = 200;

  private static final int LONGEST_TEXT = 500;

  public Condition {
    subject = subject.substring(0, Math.min(subject.length(), LONGEST_SUBJECT));
  }

  /** What stays the same while it lasts. */
  record Key(NoticeKind kind, String subject) {}

  Key key() {
    return new Key(kind, subject);
  }

  /** In English, as long as the store keeps. */
  public String english() {
    String text = this.text.english();
    return text.length() <= LONGEST_TEXT ? text : text.substring(0, LONGEST_TEXT - 3) + "...";
  }
}
