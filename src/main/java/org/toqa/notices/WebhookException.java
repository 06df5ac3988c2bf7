package org.toqa.notices;

import java.io.IOException;
import java.net.ConnectException;
import java.net.NoRouteToHostException;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.net.URI;
import java.net.UnknownHostException;
import java.time.Duration;
import javax.net.ssl.SSLException;
import org.toqa.outbound.OutboundHttp;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Why a webhook has not taken what it was sent; the message is a sentence for people. */
public final class WebhookException extends IOException {
  private static final long serialVersionUID = 1;

  /** Of Linux (ENETUNREACH), which Java has no class for. */
  private static final String NO_NETWORK = "Network is unreachable";

  private final transient Sentence sentence;

  WebhookException(Sentence sentence) {
    super(sentence.english());
    this.sentence = sentence;
  }

  /**
   * @param limit of silence
   */
  static WebhookException of(URI url, IOException failure, Duration limit) {
    String host = url.getHost();
    return switch (failure) {
      case WebhookException known -> known;
      case WebhookClient.PrivateHostException _ ->
          new WebhookException(Phrase.WEBHOOK_PRIVATE.with(host, WebhookClient.NETWORKS));
      case UnknownHostException _ -> new WebhookException(Phrase.WEBHOOK_HOST_UNKNOWN.with(host));
      case OutboundHttp.WholeLimitException late ->
          new WebhookException(Phrase.WEBHOOK_SILENT.with(host, late.limit().toSeconds()));
      case SocketTimeoutException _ ->
          new WebhookException(Phrase.WEBHOOK_SILENT.with(host, limit.toSeconds()));
      case SocketException lost when isUnreachable(lost) ->
          new WebhookException(Phrase.WEBHOOK_UNREACHABLE.with(host));
      case ConnectException _ ->
          new WebhookException(Phrase.WEBHOOK_REFUSED.with(url.getAuthority()));
      case SSLException _ ->
          new WebhookException(
              Phrase.WEBHOOK_NO_TLS.with(host, String.valueOf(failure.getMessage())));
      default ->
          new WebhookException(
              Phrase.WEBHOOK_BROKEN_OFF.with(host, String.valueOf(failure.getMessage())));
    };
  }

  private static boolean isUnreachable(SocketException failure) {
    return failure instanceof NoRouteToHostException
        || String.valueOf(failure.getMessage()).contains(NO_NETWORK);
  }

  public Sentence sentence() {
    return sentence;
  }
}
