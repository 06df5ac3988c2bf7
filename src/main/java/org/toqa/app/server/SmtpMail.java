package org.toqa.app.server;

import jakarta.mail.Authenticator;
import jakarta.mail.Message;
import jakarta.mail.MessagingException;
import jakarta.mail.PasswordAuthentication;
import jakarta.mail.Session;
import jakarta.mail.Transport;
import jakarta.mail.internet.InternetAddress;
import jakarta.mail.internet.MimeMessage;
import java.io.IOException;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.Properties;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.toqa.app.config.Configuration;
import org.toqa.web.MailSender;

/** Sends e-mail through a mail server. */
final class SmtpMail implements MailSender {
  private static final String TIMEOUT_MS = "20000";

  private final Configuration.MailServer server;

  SmtpMail(Configuration.MailServer server) {
    this.server = server;
  }

  @Override
  public String baseUrl() {
    return server.url();
  }

  @Override
  public void send(String to, String subject, String text, UUID id) throws IOException {
    try {
      MimeMessage message = new IdentifiedMessage(id);
      message.setFrom(new InternetAddress(server.from()));
      message.setRecipient(Message.RecipientType.TO, new InternetAddress(to));
      message.setSubject(subject, "UTF-8");
      message.setText(text, "UTF-8");
      message.setHeader(
          "Date", DateTimeFormatter.RFC_1123_DATE_TIME.format(OffsetDateTime.now(ZoneOffset.UTC)));
      message.setHeader("Auto-Submitted", "auto-generated");
      Transport.send(message);
    } catch (MessagingException e) {
      throw new IOException(server + " did not take it: " + e.getMessage(), e);
    }
  }

  /** A letter with an id of its own, not one of this machine's name. */
  private final class IdentifiedMessage extends MimeMessage {
    private final UUID id;

    IdentifiedMessage(UUID id) {
      super(Session.getInstance(properties(), authenticator()));
      this.id = id;
    }

    @Override
    protected void updateMessageID() throws MessagingException {
      setHeader("Message-ID", "<" + id + server.from().replaceFirst(".*@", "@") + ">");
    }
  }

  private Properties properties() {
    Properties properties = new Properties();
    properties.setProperty("mail.smtp.host", server.host());
    properties.setProperty("mail.smtp.port", Integer.toString(server.port()));
    properties.setProperty("mail.smtp.auth", Boolean.toString(server.user() != null));
    properties.setProperty("mail.smtp.connectiontimeout", TIMEOUT_MS);
    properties.setProperty("mail.smtp.timeout", TIMEOUT_MS);
    properties.setProperty("mail.smtp.writetimeout", TIMEOUT_MS);
    properties.setProperty("mail.smtp.ssl.checkserveridentity", "true");
    switch (server.security()) {
      case STARTTLS -> {
        properties.setProperty("mail.smtp.starttls.enable", "true");
        properties.setProperty("mail.smtp.starttls.required", "true");
      }
      case TLS -> properties.setProperty("mail.smtp.ssl.enable", "true");
      case NONE -> {}
    }
    return properties;
  }

  private @Nullable Authenticator authenticator() {
    String user = server.user();
    String password = server.password();
    if (user == null) {
      return null;
    }
    return new Authenticator() {
      @Override
      protected PasswordAuthentication getPasswordAuthentication() {
        return new PasswordAuthentication(user, password == null ? "" : password);
      }
    };
  }
}
