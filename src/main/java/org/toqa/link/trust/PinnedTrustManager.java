package org.toqa.link.trust;

import java.net.Socket;
import java.security.cert.CertificateException;
import java.security.cert.X509Certificate;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.X509ExtendedTrustManager;
import org.jspecify.annotations.Nullable;

/**
 * Trusts certificates that it was given, each as it is: no authority, name or date makes another
 * one good. That the other end has the certificate's key is proved by TLS itself.
 */
final class PinnedTrustManager extends X509ExtendedTrustManager {

  /** The other end is not one that this end trusts. */
  static final class UntrustedPeerException extends CertificateException {
    private static final long serialVersionUID = 1;

    UntrustedPeerException(String why) {
      super(why);
    }
  }

  private final PeerVerifier verifier;

  PinnedTrustManager(PeerVerifier verifier) {
    this.verifier = verifier;
  }

  @Override
  public void checkClientTrusted(X509Certificate[] chain, String authType, Socket socket)
      throws CertificateException {
    check(chain, socket);
  }

  @Override
  public void checkServerTrusted(X509Certificate[] chain, String authType, Socket socket)
      throws CertificateException {
    check(chain, socket);
  }

  @Override
  public void checkClientTrusted(X509Certificate[] chain, String authType, SSLEngine engine)
      throws CertificateException {
    throw unsupportedCheck();
  }

  @Override
  public void checkServerTrusted(X509Certificate[] chain, String authType, SSLEngine engine)
      throws CertificateException {
    check(chain, engine.getHandshakeApplicationProtocol());
  }

  @Override
  public void checkClientTrusted(X509Certificate[] chain, String authType)
      throws CertificateException {
    throw unsupportedCheck();
  }

  @Override
  public void checkServerTrusted(X509Certificate[] chain, String authType)
      throws CertificateException {
    throw unsupportedCheck();
  }

  @Override
  public X509Certificate[] getAcceptedIssuers() {
    return new X509Certificate[0];
  }

  private void check(X509Certificate[] chain, Socket socket) throws CertificateException {
    if (!(socket instanceof SSLSocket tls)) {
      throw unsupportedCheck();
    }
    check(chain, tls.getHandshakeApplicationProtocol());
  }

  private void check(X509Certificate[] chain, @Nullable String protocol)
      throws CertificateException {
    if (chain.length == 0) {
      throw unsupportedCheck();
    }
    Fingerprint peer = Fingerprint.of(chain[0]);
    if (!verifier.isTrusted(peer, protocol == null ? "" : protocol)) {
      throw new UntrustedPeerException("The certificate " + peer + " is not trusted.");
    }
  }

  private static UntrustedPeerException unsupportedCheck() {
    return new UntrustedPeerException("There is nothing to trust.");
  }
}
