package org.toqa.link.http;

import java.io.IOException;
import java.net.ConnectException;
import java.net.URI;
import java.net.UnknownHostException;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.net.http.HttpTimeoutException;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.UnresolvedAddressException;
import java.time.Duration;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.toqa.link.http.HttpRobotException.Reason;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.HttpTls;
import org.toqa.text.CleanText;

/**
 * The server's end of the HTTP of one robot. One connection is kept alive as long as exchanges
 * follow each other. Any thread may call it.
 */
public final class HttpRobotClient implements AutoCloseable {
  /** Of a person's patience, not of a robot that drives. */
  private static final Duration DESCRIPTION_LIMIT = Duration.ofSeconds(3);

  private static final Duration CONNECT_LIMIT = Duration.ofSeconds(3);
  private static final int LONGEST_ECHO = 80;

  /** Of the robot's {@code seq}: what another program gives it in four years, each 30 ms. */
  private static final long MOST_AHEAD = 1L << 32;

  private final HttpRobotAddress address;
  private final HttpClient http;
  private final URI description;
  private final URI wheels;

  /**
   * @throws HttpRobotException the host is no name and no address
   * @throws IOException this machine has no TLS
   */
  public HttpRobotClient(HttpRobotAddress address) throws IOException {
    this.address = address;
    description = address.uri("/v1/robot");
    wheels = address.uri("/v1/wheels");
    HttpClient.Builder builder =
        HttpClient.newBuilder()
            .version(HttpClient.Version.HTTP_1_1)
            .followRedirects(HttpClient.Redirect.NEVER)
            .connectTimeout(CONNECT_LIMIT);
    Fingerprint pinned = address.fingerprint();
    http = (pinned == null ? builder : HttpTls.pin(builder, pinned)).build();
  }

  /**
   * Asks what the robot is; waits for some seconds at most.
   *
   * @throws HttpRobotException it does not say
   */
  public RobotDescription describe() throws HttpRobotException {
    CompletableFuture<HttpResponse<byte[]>> asked = send(request(description).GET().build());
    try {
      return HttpRobotCodec.decodeDescription(
          body(asked.get(DESCRIPTION_LIMIT.toMillis(), TimeUnit.MILLISECONDS)));
    } catch (TimeoutException e) {
      throw new HttpRobotException(Reason.DOES_NOT_ANSWER, "it does not answer", e);
    } catch (ExecutionException e) {
      throw failure(e.getCause() == null ? e : e.getCause());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new HttpRobotException(Reason.DOES_NOT_ANSWER, "nobody waits any more", e);
    } finally {
      asked.cancel(true);
    }
  }

  /**
   * Sends an order, and does not wait.
   *
   * @return completes with the answer, or with an {@link HttpRobotException}; to cancel it ends the
   *     exchange and its connection
   */
  public Exchange exchange(WheelOrder order) {
    long begun = System.nanoTime();
    CompletableFuture<HttpResponse<byte[]>> sent =
        send(
            request(wheels)
                .header("Content-Type", "application/json")
                .POST(BodyPublishers.ofByteArray(HttpRobotCodec.encode(order)))
                .build());
    return new Exchange(order.seq(), sent, begun);
  }

  /** An order on its way, and its answer. */
  public static final class Exchange {
    private final long seq;
    private final CompletableFuture<HttpResponse<byte[]>> sent;

    /** The answer, once it is known when it came. */
    private final CompletableFuture<HttpResponse<byte[]>> answered;

    private final long begun;
    private volatile long ended;
    private volatile boolean isCancelled;

    private Exchange(long seq, CompletableFuture<HttpResponse<byte[]>> sent, long begun) {
      this.seq = seq;
      this.sent = sent;
      this.begun = begun;
      this.answered = sent.whenComplete((_, _) -> ended = System.nanoTime());
    }

    /** When the order was sent, by {@link System#nanoTime}. */
    public long begun() {
      return begun;
    }

    /** When the answer came, of an exchange that is done; else when it failed or was given up. */
    public long ended() {
      return ended;
    }

    /**
     * Waits for the answer.
     *
     * @return whether it is there, or has failed
     */
    public boolean await(Duration limit) {
      try {
        var _ = answered.get(limit.toNanos(), TimeUnit.NANOSECONDS);
        return true;
      } catch (TimeoutException e) {
        return false;
      } catch (ExecutionException | CancellationException e) {
        return true;
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return answered.isDone();
      }
    }

    /**
     * The answer of an exchange that is done, or was cancelled.
     *
     * @throws HttpRobotException there is none
     */
    public WheelReport report() throws HttpRobotException {
      try {
        return checked(HttpRobotCodec.decodeReport(body(answered.join())));
      } catch (CancellationException e) {
        throw new HttpRobotException(Reason.DOES_NOT_ANSWER, "it does not answer in time", e);
      } catch (CompletionException e) {
        if (isCancelled) {
          throw new HttpRobotException(Reason.DOES_NOT_ANSWER, "it does not answer in time", e);
        }
        throw failure(e.getCause() == null ? e : e.getCause());
      }
    }

    private WheelReport checked(WheelReport report) throws HttpRobotException {
      if (report.seq() - seq > MOST_AHEAD) {
        throw new HttpRobotException(
            Reason.NONSENSE, "seq is %d, where %d was sent last".formatted(report.seq(), seq));
      }
      return report;
    }

    /** Ends it, and its connection. */
    public void cancel() {
      isCancelled = true;
      sent.cancel(true);
    }
  }

  private HttpRequest.Builder request(URI uri) {
    return HttpRequest.newBuilder(uri).header("Authorization", address.token().authorization());
  }

  private CompletableFuture<HttpResponse<byte[]>> send(HttpRequest request) {
    return http.sendAsync(
        request, BodyHandlers.limiting(BodyHandlers.ofByteArray(), HttpRobotCodec.MOST_BYTES));
  }

  private static byte[] body(HttpResponse<byte[]> response) throws HttpRobotException {
    return switch (response.statusCode()) {
      case 200 -> response.body();
      case 401, 403 ->
          throw new HttpRobotException(
              Reason.WRONG_TOKEN, "it does not accept the token (" + response.statusCode() + ")");
      default ->
          throw new HttpRobotException(
              Reason.REFUSES, "it answers with the status " + response.statusCode());
    };
  }

  private static HttpRobotException failure(Throwable thrown) {
    if (HttpTls.isOtherCertificate(thrown)) {
      return new HttpRobotException(
          Reason.ANOTHER_CERTIFICATE, "it shows another certificate", thrown);
    }
    for (Throwable e = thrown; e != null; e = e.getCause()) {
      switch (e) {
        case HttpRobotException known -> {
          return known;
        }
        case HttpTimeoutException _ -> {
          return new HttpRobotException(Reason.DOES_NOT_ANSWER, "it does not answer", thrown);
        }
        case UnresolvedAddressException _, UnknownHostException _ -> {
          return new HttpRobotException(
              Reason.HOST_NOT_KNOWN, "nothing in the network has its name", thrown);
        }
        case ConnectException _ when isRefused(thrown) -> {
          return new HttpRobotException(Reason.NOBODY_LISTENS, "nobody listens there", thrown);
        }
        default -> {}
      }
    }
    return isTooLong(thrown)
        ? new HttpRobotException(
            Reason.NONSENSE, "it is longer than " + HttpRobotCodec.MOST_BYTES + " bytes", thrown)
        : new HttpRobotException(
            Reason.CANNOT_BE_REACHED,
            CleanText.of(String.valueOf(thrown.getMessage()), LONGEST_ECHO),
            thrown);
  }

  /** The host is there and says no; its client leaves the words to the cause, if it has any. */
  private static boolean isRefused(Throwable thrown) {
    for (Throwable e = thrown; e != null; e = e.getCause()) {
      if (String.valueOf(e.getMessage()).contains("refused")
          || e instanceof ClosedChannelException) {
        return true;
      }
    }
    return false;
  }

  private static boolean isTooLong(Throwable thrown) {
    return String.valueOf(thrown.getMessage()).contains("body exceeds capacity");
  }

  /** Ends what is under way. */
  @Override
  public void close() {
    http.shutdownNow();
  }
}
