package org.toqa.web;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.atomic.AtomicReference;
import org.toqa.fleet.Answer;
import org.toqa.wording.Phrase;

/** The sites of a server that has one, and makes no other. */
record OneSite(Services first) implements Sites {
  private static final AtomicReference<String> LOG_LEVEL = new AtomicReference<>("INFO");

  @Override
  public Optional<Services> find(long id) {
    return Optional.of(first).filter(services -> services.site().id() == id);
  }

  @Override
  public Optional<Services> find(String name) {
    return Optional.of(first).filter(services -> services.site().name().equals(name));
  }

  @Override
  public List<Services> running() {
    return List.of(first);
  }

  @Override
  public List<SiteSummary> all() {
    return List.of(SiteSummary.of(first));
  }

  @Override
  public List<ServerSetting> settings() {
    return List.of(
        new ServerSetting("port", "8080", null, "a whole number"),
        new ServerSetting("database.password", null, "TOQA_DATABASE_PASSWORD", "a password"),
        new ServerSetting("url", "", null, "an address"),
        new ServerSetting("lostAfter", "20", "lostAfter in /etc/toqa.yaml", "seconds"));
  }

  @Override
  public String logLevel() {
    return String.valueOf(LOG_LEVEL.get());
  }

  @Override
  public void changeLogLevel(String level, String by) {
    LOG_LEVEL.set(level);
  }

  @Override
  public CompletionStage<Answer<SiteSummary>> add(
      String name, String manager, String passwordHash, String by) {
    return CompletableFuture.completedFuture(
        new Answer.Rejected<>("name", Phrase.SITE_EXISTS.with(name)));
  }

  @Override
  public CompletionStage<Answer<String>> remove(String name, String by) {
    return CompletableFuture.completedFuture(
        find(name).isPresent()
            ? new Answer.Conflict<>(Phrase.FIRST_SITE_STAYS.with(), null)
            : new Answer.Unknown<>(Phrase.NO_SUCH_SITE.with(name)));
  }
}
