package org.toqa.outbound;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.apache.hc.client5.http.DnsResolver;
import org.apache.hc.client5.http.classic.methods.HttpUriRequestBase;
import org.apache.hc.client5.http.config.ConnectionConfig;
import org.apache.hc.client5.http.config.RequestConfig;
import org.apache.hc.client5.http.impl.classic.CloseableHttpClient;
import org.apache.hc.client5.http.impl.classic.HttpClients;
import org.apache.hc.client5.http.impl.io.PoolingHttpClientConnectionManagerBuilder;
import org.apache.hc.core5.http.ClassicHttpResponse;
import org.apache.hc.core5.http.io.SocketConfig;
import org.apache.hc.core5.util.Timeout;

/**
 * A client for addresses that people have typed: redirects are not followed, no proxy is asked,
 * nothing is sent again, unpacked or kept for the next request, and time is bounded also where the
 * other side answers a byte now and then.
 */
public final class OutboundHttp implements AutoCloseable {
  private final Duration wholeLimit;
  private final CloseableHttpClient client;
  private final ScheduledExecutorService limiter;

  /** Reads what it needs of an answer; the rest is not read. */
  @FunctionalInterface
  public interface AnswerReader<T> {
    T read(ClassicHttpResponse answer) throws IOException;
  }

  /** A request took longer than it may as a whole. */
  public static final class WholeLimitException extends IOException {
    private static final long serialVersionUID = 1;

    private final Duration limit;

    public WholeLimitException(Duration limit, IOException cause) {
      super("It did not end within " + limit.toMillis() + " ms.", cause);
      this.limit = limit;
    }

    public Duration limit() {
      return limit;
    }
  }

  /**
   * @param name what its thread is for
   * @param limit of silence, while it connects and later
   * @param wholeLimit of a request from its begin to its end
   * @param connections at once
   * @param resolver says where a name leads, each time that one is connected to
   */
  public OutboundHttp(
      String name, Duration limit, Duration wholeLimit, int connections, DnsResolver resolver) {
    this.wholeLimit = wholeLimit;
    Timeout silence = Timeout.of(limit);
    client =
        HttpClients.custom()
            .setConnectionManager(
                PoolingHttpClientConnectionManagerBuilder.create()
                    .setDnsResolver(resolver)
                    .setDefaultConnectionConfig(
                        ConnectionConfig.custom()
                            .setConnectTimeout(silence)
                            .setSocketTimeout(silence)
                            .build())
                    .setDefaultSocketConfig(SocketConfig.custom().setSoTimeout(silence).build())
                    .setMaxConnPerRoute(connections)
                    .setMaxConnTotal(connections)
                    .build())
            .setDefaultRequestConfig(
                RequestConfig.custom()
                    .setResponseTimeout(silence)
                    .setConnectionRequestTimeout(silence)
                    .build())
            .setConnectionReuseStrategy((request, response, context) -> false)
            .setUserAgent("Toqa")
            .disableRedirectHandling()
            .disableAutomaticRetries()
            .disableCookieManagement()
            .disableAuthCaching()
            .disableContentCompression()
            .build();
    limiter =
        Executors.newSingleThreadScheduledExecutor(
            Thread.ofVirtual().name("limit of " + name).factory());
  }

  /**
   * Sends it, and gives what was read of the answer.
   *
   * @throws WholeLimitException it was ended here
   */
  public <T> T send(HttpUriRequestBase request, AnswerReader<T> reader) throws IOException {
    AtomicBoolean isLate = new AtomicBoolean();
    ScheduledFuture<?> end =
        limiter.schedule(
            () -> {
              isLate.set(true);
              request.abort();
            },
            wholeLimit.toMillis(),
            TimeUnit.MILLISECONDS);
    try {
      return reader.read(client.executeOpen(null, request, null));
    } catch (IOException e) {
      throw isLate.get() ? new WholeLimitException(wholeLimit, e) : e;
    } finally {
      end.cancel(false);
      request.abort(); // nobody reads on
    }
  }

  @Override
  public void close() throws IOException {
    limiter.shutdownNow();
    client.close();
  }
}
