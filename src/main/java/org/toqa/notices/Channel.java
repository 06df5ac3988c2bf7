package org.toqa.notices;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** By what a person is told. */
public enum Channel {
  /** The count at the menu, in the title and on the icon of every page. */
  BADGE,
  SOUND,
  /** By the browser, over other windows, while a page is open. */
  BROWSER,
  EMAIL;

  /** As programs and the store name it. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  public static Optional<Channel> ofWord(String word) {
    return Arrays.stream(values()).filter(channel -> channel.word().equals(word)).findFirst();
  }
}
