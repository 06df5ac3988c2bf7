package org.toqa.app;

import java.io.IOException;
import java.security.GeneralSecurityException;
import java.security.PrivateKey;
import java.security.Signature;
import java.security.cert.X509Certificate;
import java.util.List;
import org.apache.tomcat.util.net.jsse.PEMFile;

/** A certificate and a private key, each from a PEM file. */
record PemPair(X509Certificate certificate, PrivateKey key) {

  /**
   * @throws IOException they cannot be read, or do not belong together; the message says what to do
   */
  static PemPair read(Configuration.Tls files) throws IOException {
    try {
      List<X509Certificate> certificates =
          new PEMFile(files.certificate().toString()).getCertificates();
      PrivateKey key = new PEMFile(files.key().toString()).getPrivateKey();
      if (certificates.isEmpty() || key == null) {
        throw new GeneralSecurityException(
            certificates.isEmpty() ? "no certificate is in the first" : "no key is in the second");
      }
      PemPair pair = new PemPair(certificates.getFirst(), key);
      if (!pair.belongsTogether()) {
        throw new GeneralSecurityException("the key is that of another certificate");
      }
      return pair;
    } catch (GeneralSecurityException | IOException | IllegalArgumentException e) {
      throw new IOException(
          "tls.certificate \"%s\" and tls.key \"%s\" cannot be used (%s): give a certificate and its own key without a password, both as PEM."
              .formatted(files.certificate(), files.key(), e.getMessage()),
          e);
    }
  }

  /** What the key signs, the certificate's key verifies. */
  private boolean belongsTogether() throws GeneralSecurityException {
    byte[] something = {1, 2, 3};
    Signature signature = Signature.getInstance(algorithm());
    signature.initSign(key);
    signature.update(something);
    byte[] signed = signature.sign();
    signature.initVerify(certificate);
    signature.update(something);
    return key.getAlgorithm().equals(certificate.getPublicKey().getAlgorithm())
        && signature.verify(signed);
  }

  private String algorithm() {
    return switch (key.getAlgorithm()) {
      case "EC" -> "SHA256withECDSA";
      case "RSA" -> "SHA256withRSA";
      default -> key.getAlgorithm();
    };
  }
}
