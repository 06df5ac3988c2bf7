package org.toqa.link.trust;

import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.X509Certificate;
import javax.net.ssl.KeyManager;
import javax.net.ssl.KeyManagerFactory;

/** An end's own key and self-signed certificate: what it proves itself by. */
public final class Identity {

  static final String ALIAS = "link";

  private final KeyStore keys;
  private final char[] password;
  private final Fingerprint fingerprint;

  /**
   * @param keys has a key and its certificate under {@link #ALIAS}
   */
  Identity(KeyStore keys, char[] password) throws GeneralSecurityException {
    this.keys = keys;
    this.password = password.clone();
    if (!keys.isKeyEntry(ALIAS)
        || !(keys.getCertificate(ALIAS) instanceof X509Certificate certificate)) {
      throw new GeneralSecurityException("there is no key in it");
    }
    fingerprint = Fingerprint.of(certificate);
  }

  /** What the other end pins. */
  public Fingerprint fingerprint() {
    return fingerprint;
  }

  KeyManager[] keyManagers() throws GeneralSecurityException {
    KeyManagerFactory factory = KeyManagerFactory.getInstance("SunX509");
    factory.init(keys, password);
    return factory.getKeyManagers();
  }
}
