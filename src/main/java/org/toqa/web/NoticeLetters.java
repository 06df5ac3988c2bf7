package org.toqa.web;

import java.io.IOException;
import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.time.format.FormatStyle;
import java.util.Locale;
import org.toqa.notices.Delivery;
import org.toqa.notices.LetterSender;
import org.toqa.notices.Notice;
import org.toqa.notices.NoticePreferences;

/** Letters of notices, in the language of who gets them. */
public final class NoticeLetters implements LetterSender {
  private final MailSender mail;

  public NoticeLetters(MailSender mail) {
    this.mail = mail;
  }

  @Override
  public void send(String to, NoticePreferences preferences, Delivery delivery, Notice notice)
      throws IOException {
    Texts texts =
        Texts.in(Language.ofTag(preferences.language()).orElse(Language.ENGLISH).locale());
    String kind = texts.get("notices.kind." + notice.condition().kind().word());
    String said = texts.text(notice.condition().text());
    Instant end = notice.endedAt();
    String begun = time(notice.begunAt(), preferences.zone(), texts.locale());
    StringBuilder text = new StringBuilder(kind).append("\n\n").append(said).append("\n\n");
    text.append(texts.get("notices.letter.begun", begun)).append('\n');
    if (end != null) {
      text.append(texts.get("notices.letter.ended", time(end, preferences.zone(), texts.locale())))
          .append('\n');
    }
    text.append('\n')
        .append(texts.get("notices.letter.where", mail.baseUrl() + "/notices"))
        .append('\n')
        .append(texts.get("notices.letter.why", mail.baseUrl() + "/notices/settings"))
        .append('\n');
    mail.send(
        to,
        texts.get(end == null ? "notices.letter.subject" : "notices.letter.subject.ended", kind),
        text.toString(),
        delivery.uid());
  }

  private static String time(Instant at, ZoneId zone, Locale locale) {
    return DateTimeFormatter.ofLocalizedDateTime(FormatStyle.MEDIUM, FormatStyle.LONG)
        .withLocale(locale)
        .withZone(zone)
        .format(at);
  }
}
