package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.icegreen.greenmail.util.GreenMail;
import com.icegreen.greenmail.util.GreenMailUtil;
import com.icegreen.greenmail.util.ServerSetup;
import jakarta.mail.internet.MimeMessage;
import java.io.IOException;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.app.config.Configuration;
import org.toqa.app.config.Configuration.MailSecurity;

/** Letters over a real SMTP connection. */
class SmtpMailTest {
  private final GreenMail server =
      new GreenMail(new ServerSetup(0, "127.0.0.1", ServerSetup.PROTOCOL_SMTP));

  @BeforeEach
  void start() {
    server.setUser("toqa@example.org", "toqa", "secret");
    server.start();
  }

  @AfterEach
  void stop() {
    server.stop();
  }

  @Test
  void aLetterArrives() throws Exception {
    mail(MailSecurity.NONE, "toqa", "secret")
        .send("ann@example.org", "Ein Paßwort", "Grüße\nhttps://toqa.example.org/reset?secret=x\n");

    assertTrue(server.waitForIncomingEmail(20_000, 1));
    MimeMessage letter = server.getReceivedMessages()[0];
    assertEquals("Ein Paßwort", letter.getSubject());
    assertEquals("toqa@example.org", letter.getFrom()[0].toString());
    assertEquals("ann@example.org", letter.getAllRecipients()[0].toString());
    assertEquals(1, letter.getAllRecipients().length);
    assertTrue(letter.getContent().toString().contains("Grüße"), GreenMailUtil.getBody(letter));
    assertTrue(letter.getSentDate() != null);
  }

  @Test
  void withoutTheEncryptionThatIsAskedForNothingIsSent() {
    IOException refused =
        assertThrows(
            IOException.class,
            () -> mail(MailSecurity.STARTTLS, null, null).send("ann@example.org", "x", "x"));

    assertTrue(refused.toString().contains("STARTTLS"), refused.toString());
    assertEquals(0, server.getReceivedMessages().length);
  }

  @Test
  void aWrongPasswordIsToldWithoutIt() {
    IOException refused =
        assertThrows(
            IOException.class,
            () -> mail(MailSecurity.NONE, "toqa", "wrong-one").send("ann@example.org", "x", "x"));

    assertFalse(refused.toString().contains("wrong-one"), refused.toString());
    assertEquals(0, server.getReceivedMessages().length);
  }

  private SmtpMail mail(MailSecurity security, @Nullable String user, @Nullable String password) {
    return new SmtpMail(
        new Configuration.MailServer(
            "127.0.0.1",
            server.getSmtp().getPort(),
            security,
            user,
            password,
            "toqa@example.org",
            "https://toqa.example.org"));
  }
}
