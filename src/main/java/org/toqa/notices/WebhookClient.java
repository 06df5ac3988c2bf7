package org.toqa.notices;

import java.io.IOException;
import java.net.InetAddress;
import java.net.URI;
import java.net.UnknownHostException;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.apache.hc.client5.http.DnsResolver;
import org.apache.hc.client5.http.classic.methods.HttpPost;
import org.apache.hc.core5.http.ClassicHttpResponse;
import org.apache.hc.core5.http.ContentType;
import org.apache.hc.core5.http.io.entity.StringEntity;
import org.toqa.outbound.OutboundHttp;
import org.toqa.wording.Phrase;

/**
 * Posts to webhooks. The address that a name has is checked and then really connected to, each
 * time, so that a name which leads elsewhere a moment later helps nobody; of an answer nothing but
 * its status is read.
 */
final class WebhookClient implements AutoCloseable {
  private static final Duration LIMIT = Duration.ofSeconds(10);

  /** Of a request as a whole, also of a receiver that answers a byte now and then. */
  private static final Duration WHOLE_LIMIT = Duration.ofSeconds(20);

  /** The setting that names where else than to the Internet a webhook may lead. */
  static final String NETWORKS = "webhooks.networks";

  private static final int SUCCESS = 200;
  private static final int REDIRECT = 300;

  private final WebhookAddresses addresses;
  private final OutboundHttp http;

  WebhookClient(WebhookAddresses addresses) {
    this.addresses = addresses;
    this.http =
        new OutboundHttp("webhooks", LIMIT, WHOLE_LIMIT, Webhook.MOST, new CheckedResolver());
  }

  /** Resolves to addresses only to which a webhook may lead. */
  private final class CheckedResolver implements DnsResolver {
    @Override
    public InetAddress[] resolve(String host) throws UnknownHostException {
      List<InetAddress> allowed =
          Arrays.stream(InetAddress.getAllByName(unbracketed(host)))
              .filter(addresses::allows)
              .toList();
      if (allowed.isEmpty()) {
        throw new PrivateHostException(host);
      }
      return allowed.toArray(InetAddress[]::new);
    }

    @Override
    public String resolveCanonicalHostname(String host) {
      return host;
    }
  }

  /** A resolver may say no in no other way. */
  static final class PrivateHostException extends UnknownHostException {
    private static final long serialVersionUID = 1;

    PrivateHostException(String host) {
      super(host);
    }
  }

  private static String unbracketed(String host) {
    return host.startsWith("[") ? host.substring(1, host.length() - 1) : host;
  }

  /**
   * Returns when the receiver has taken it.
   *
   * @throws WebhookException it did not
   */
  void post(URI url, String body, Map<String, String> headers) throws WebhookException {
    try {
      send(url, body, headers);
    } catch (IOException e) {
      throw WebhookException.of(url, e, LIMIT);
    }
  }

  private void send(URI url, String body, Map<String, String> headers) throws IOException {
    if (!url.getScheme().toLowerCase(Locale.ROOT).equals("https")) {
      requireNamed(url);
    }
    HttpPost request = new HttpPost(url);
    headers.forEach(request::setHeader);
    request.setEntity(new StringEntity(body, ContentType.APPLICATION_JSON));
    int status = http.send(request, ClassicHttpResponse::getCode);
    if (status < SUCCESS || status >= REDIRECT) {
      throw new WebhookException(Phrase.WEBHOOK_STATUS.with(url.getHost(), status));
    }
  }

  /** Unencrypted only within networks that the configuration names. */
  private void requireNamed(URI url) throws IOException {
    for (InetAddress address : InetAddress.getAllByName(unbracketed(url.getHost()))) {
      if (!addresses.isNamed(address)) {
        throw new WebhookException(Phrase.WEBHOOK_UNENCRYPTED.with(NETWORKS));
      }
    }
  }

  @Override
  public void close() throws IOException {
    http.close();
  }
}
