package org.toqa.web;

import java.util.UUID;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/** A letter box that takes everything. */
public final class TestMailbox implements MailSender {
  public record Message(String to, String subject, String text) {}

  private final BlockingQueue<Message> messages = new LinkedBlockingQueue<>();

  @Override
  public String baseUrl() {
    return "https://toqa.example.org";
  }

  @Override
  public void send(String to, String subject, String text, UUID id) {
    messages.add(new Message(to, subject, text));
  }

  /** The next letter, or null when none comes. */
  @Nullable
  public Message next(long seconds) throws InterruptedException {
    return messages.poll(seconds, TimeUnit.SECONDS);
  }
}
