package org.toqa.web;

import java.io.IOException;
import java.util.UUID;

/** Sends e-mails. */
public interface MailSender {

  /** The address of these pages as e-mails have it, without a slash at its end. */
  String baseUrl();

  /**
   * Returns when the mail server has taken the e-mail; that may take a minute.
   *
   * @param to an e-mail address
   * @throws IOException the mail server did not take it
   */
  default void send(String to, String subject, String text) throws IOException {
    send(to, subject, text, UUID.randomUUID());
  }

  /**
   * The same.
   *
   * @param id of the e-mail: who gets it twice sees by it that it is one
   */
  void send(String to, String subject, String text, UUID id) throws IOException;
}
