package org.toqa.web;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.toqa.fleet.Answer;
import org.toqa.wording.Phrase;

/** The sites of a server that has one, and makes no other. */
record OneSite(Services first) implements Sites {
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
