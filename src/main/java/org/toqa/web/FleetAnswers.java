package org.toqa.web;

import java.time.Duration;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.toqa.fleet.CheckRefusedException;
import org.toqa.persistence.StoreException;

/** Waits for the fleet on behalf of a request. */
public final class FleetAnswers {
  private static final Duration TIMEOUT = Duration.ofSeconds(10);

  private FleetAnswers() {}

  /**
   * @throws StoreException when nothing was done, since the store did not answer
   * @throws CheckRefusedException when nothing was done, since an order was not checked
   * @throws FleetUnavailableException when there is no answer within ten seconds; the command may
   *     still have been stored
   */
  public static <T> T await(CompletionStage<T> answer) {
    return await(answer, TIMEOUT);
  }

  /** The same for what takes its time, such as a database that is made. */
  public static <T> T await(CompletionStage<T> answer, Duration limit) {
    try {
      return answer.toCompletableFuture().get(limit.toMillis(), TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new FleetUnavailableException(e);
    } catch (ExecutionException e) {
      Throwable cause = e.getCause();
      if (cause instanceof CompletionException && cause.getCause() != null) {
        cause = cause.getCause();
      }
      switch (cause) {
        case StoreException refused -> throw refused;
        case CheckRefusedException refused -> throw refused;
        case null, default -> throw new FleetUnavailableException(e);
      }
    } catch (TimeoutException e) {
      throw new FleetUnavailableException(e);
    }
  }
}
