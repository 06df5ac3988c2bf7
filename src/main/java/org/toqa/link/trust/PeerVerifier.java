package org.toqa.link.trust;

/** Whom an end of the link trusts. */
@FunctionalInterface
public interface PeerVerifier {

  /**
   * Called while the other end waits, by the connection's own thread.
   *
   * @param peer of the certificate that the other end has shown
   * @param protocol the protocol that it asks for (ALPN), one of {@link LinkTls}; empty where it
   *     did not say
   */
  boolean isTrusted(Fingerprint peer, String protocol);
}
