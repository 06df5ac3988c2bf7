package org.toqa.link.trust;

import java.math.BigInteger;
import java.security.GeneralSecurityException;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.security.SecureRandom;
import java.security.cert.X509Certificate;
import java.security.spec.ECGenParameterSpec;
import java.time.Instant;
import java.util.Date;
import javax.security.auth.x500.X500Principal;
import org.bouncycastle.cert.jcajce.JcaX509CertificateConverter;
import org.bouncycastle.cert.jcajce.JcaX509v3CertificateBuilder;
import org.bouncycastle.operator.OperatorCreationException;
import org.bouncycastle.operator.jcajce.JcaContentSignerBuilder;

/**
 * A new key on the curve P-256 with a certificate signed by itself. It has no end: it is valid as
 * long as the other end pins it, and a robot's clock may show any time.
 */
record SelfSignedCertificate(KeyPair keys, X509Certificate certificate) {

  private static final Instant ALWAYS = Instant.EPOCH;

  /** RFC 5280, 4.1.2.5: no well-defined end. */
  private static final Instant NEVER = Instant.parse("9999-12-31T23:59:59Z");

  private static final int SERIAL_BITS = 63;

  static SelfSignedCertificate generate() throws GeneralSecurityException {
    SecureRandom random = new SecureRandom();
    KeyPairGenerator generator = KeyPairGenerator.getInstance("EC");
    generator.initialize(new ECGenParameterSpec("secp256r1"), random);
    KeyPair keys = generator.generateKeyPair();
    X500Principal name = new X500Principal("CN=Toqa robot link");
    try {
      return new SelfSignedCertificate(
          keys,
          new JcaX509CertificateConverter()
              .getCertificate(
                  new JcaX509v3CertificateBuilder(
                          name,
                          new BigInteger(SERIAL_BITS, random),
                          Date.from(ALWAYS),
                          Date.from(NEVER),
                          name,
                          keys.getPublic())
                      .build(
                          new JcaContentSignerBuilder("SHA256withECDSA")
                              .build(keys.getPrivate()))));
    } catch (OperatorCreationException e) {
      throw new GeneralSecurityException("no certificate could be signed", e);
    }
  }
}
