package org.toqa.web;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/** A letter box that takes everything. */
final class Letters implements Mail {
  record Letter(String to, String subject, String text) {}

  private final BlockingQueue<Letter> letters = new LinkedBlockingQueue<>();

  @Override
  public String site() {
    return "https://toqa.example.org";
  }

  @Override
  public void send(String to, String subject, String text) {
    letters.add(new Letter(to, subject, text));
  }

  /** The next letter, or null when none comes. */
  @Nullable Letter next(long seconds) throws InterruptedException {
    return letters.poll(seconds, TimeUnit.SECONDS);
  }
}
