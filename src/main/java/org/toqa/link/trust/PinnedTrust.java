package org.toqa.link.trust;

import java.net.Socket;
import java.security.cert.CertificateException;
import java.security.cert.X509Certificate;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.X509ExtendedTrustManager;

/**
 * Trusts certificates that were told it, each as it is: no authority, name or date makes another
 * one good. That the other end has the certificate's key is proved by TLS itself.
 */
final class PinnedTrust extends X509ExtendedTrustManager {

  /** The other end is not one that this end trusts. */
  static final class StrangerException extends CertificateException {
    private static final long serialVersionUID = 1;

    StrangerException(String why) {
      super(why);
    }
  }

  private final Admission admission;

  PinnedTrust(Admission admission) {
    this.admission = admission;
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
    throw withoutSocket();
  }

  @Override
  public void checkServerTrusted(X509Certificate[] chain, String authType, SSLEngine engine)
      throws CertificateException {
    throw withoutSocket();
  }

  @Override
  public void checkClientTrusted(X509Certificate[] chain, String authType)
      throws CertificateException {
    throw withoutSocket();
  }

  @Override
  public void checkServerTrusted(X509Certificate[] chain, String authType)
      throws CertificateException {
    throw withoutSocket();
  }

  @Override
  public X509Certificate[] getAcceptedIssuers() {
    return new X509Certificate[0];
  }

  private void check(X509Certificate[] chain, Socket socket) throws CertificateException {
    if (chain.length == 0 || !(socket instanceof SSLSocket tls)) {
      throw withoutSocket();
    }
    String protocol = tls.getHandshakeApplicationProtocol();
    Fingerprint peer = Fingerprint.of(chain[0]);
    if (!admission.admits(peer, protocol == null ? "" : protocol)) {
      throw new StrangerException("The certificate " + peer + " is not trusted.");
    }
  }

  private static StrangerException withoutSocket() {
    return new StrangerException("There is nothing to trust.");
  }
}
