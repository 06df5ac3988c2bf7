package org.toqa.notices;

import java.io.IOException;

/** Writes and sends letters of notices. */
public interface LetterSender {

  /**
   * Returns when the mail server has taken it; that may take a minute.
   *
   * @param to an e-mail address
   * @param preferences of who gets it: his language and time zone
   * @throws IOException the mail server did not take it
   */
  void send(String to, NoticePreferences preferences, Delivery delivery, Notice notice)
      throws IOException;
}
