package org.toqa.app.server;

import org.toqa.app.config.Configuration;
import org.toqa.web.MailSender;

/** Sends letters to a mail server of a test. */
public final class MailToTest {
  private MailToTest() {}

  /**
   * @param port of a mail server on loopback, without encryption
   */
  public static MailSender at(int port) {
    return new SmtpMail(
        new Configuration.MailServer(
            "127.0.0.1",
            port,
            Configuration.MailSecurity.NONE,
            null,
            null,
            "toqa@example.org",
            "https://toqa.example.org"));
  }
}
