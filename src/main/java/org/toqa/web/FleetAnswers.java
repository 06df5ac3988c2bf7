package org.toqa.web;

import java.time.Duration;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.toqa.fleet.Answer;

/** Waits for the fleet on behalf of a request. */
public final class FleetAnswers {
  private static final Duration LIMIT = Duration.ofSeconds(10);

  private FleetAnswers() {}

  /**
   * @throws FleetSilentException when there is no answer within ten seconds or the store failed;
   *     the wish may still have been stored
   */
  public static <T> Answer<T> await(CompletionStage<Answer<T>> wish) {
    try {
      return wish.toCompletableFuture().get(LIMIT.toMillis(), TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new FleetSilentException(e);
    } catch (ExecutionException | TimeoutException e) {
      throw new FleetSilentException(e);
    }
  }
}
