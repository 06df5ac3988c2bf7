package org.toqa.link.trust;

import com.sun.net.httpserver.HttpsConfigurator;
import java.io.IOException;
import java.net.http.HttpClient;
import java.security.GeneralSecurityException;
import javax.net.ssl.KeyManager;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLParameters;
import javax.net.ssl.TrustManager;
import org.jspecify.annotations.Nullable;

/**
 * TLS 1.3 for HTTP, where the server shows a certificate that its client knows by its fingerprint,
 * and the client proves itself by a token.
 */
public final class HttpTls {
  private HttpTls() {}

  /**
   * Lets a client trust one certificate, and no other.
   *
   * @param pinned what the other end shows
   * @throws IOException this machine has no TLS
   */
  public static HttpClient.Builder pin(HttpClient.Builder client, Fingerprint pinned)
      throws IOException {
    SSLParameters parameters = new SSLParameters();
    parameters.setProtocols(new String[] {"TLSv1.3"});
    return client
        .sslContext(context(null, new PinnedTrustManager((peer, _) -> peer.equals(pinned))))
        .sslParameters(parameters);
  }

  /**
   * What lets a server show its certificate.
   *
   * @throws IOException this machine has no TLS
   */
  public static HttpsConfigurator configurator(Identity identity) throws IOException {
    try {
      return new HttpsConfigurator(
          context(identity.keyManagers(), new PinnedTrustManager((_, _) -> false)));
    } catch (GeneralSecurityException e) {
      throw cannotBeHad(e);
    }
  }

  /** Whether a client failed since the other end shows another certificate than the pinned one. */
  public static boolean isOtherCertificate(Throwable failure) {
    for (Throwable e = failure; e != null; e = e.getCause()) {
      if (e instanceof PinnedTrustManager.UntrustedPeerException) {
        return true;
      }
    }
    return false;
  }

  private static SSLContext context(KeyManager @Nullable [] keys, TrustManager trusted)
      throws IOException {
    try {
      SSLContext context = SSLContext.getInstance("TLSv1.3");
      context.init(keys, new TrustManager[] {trusted}, null);
      return context;
    } catch (GeneralSecurityException e) {
      throw cannotBeHad(e);
    }
  }

  private static IOException cannotBeHad(GeneralSecurityException e) {
    return new IOException("TLS cannot be had: " + e.getMessage(), e);
  }
}
