package org.toqa.app.server;

import java.io.IOException;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.PrivateKey;
import java.security.Signature;
import java.security.cert.X509Certificate;
import java.util.List;
import org.apache.tomcat.util.net.jsse.PEMFile;

/** A certificate and a private key, each from a PEM file. */
record CertificateWithKey(X509Certificate certificate, PrivateKey key) {

  /**
   * @param setting what the settings of both files begin with, such as {@code tls}
   * @throws IOException they cannot be read, or do not belong together; the message says what to do
   */
  static CertificateWithKey read(String setting, Path certificateFile, Path keyFile)
      throws IOException {
    try {
      List<X509Certificate> certificates =
          new PEMFile(certificateFile.toString()).getCertificates();
      PrivateKey key = new PEMFile(keyFile.toString()).getPrivateKey();
      if (certificates.isEmpty() || key == null) {
        throw new GeneralSecurityException(
            certificates.isEmpty() ? "no certificate is in the first" : "no key is in the second");
      }
      CertificateWithKey pair = new CertificateWithKey(certificates.getFirst(), key);
      if (!pair.isKeyPair()) {
        throw new GeneralSecurityException("the key is that of another certificate");
      }
      return pair;
    } catch (GeneralSecurityException | IOException | IllegalArgumentException e) {
      throw new IOException(
          "%1$s.certificate \"%2$s\" and %1$s.key \"%3$s\" cannot be used (%4$s): give a certificate and its own key without a password, both as PEM."
              .formatted(setting, certificateFile, keyFile, e.getMessage()),
          e);
    }
  }

  /** What the key signs, the certificate's key verifies. */
  private boolean isKeyPair() throws GeneralSecurityException {
    byte[] probe = {1, 2, 3};
    Signature signature = Signature.getInstance(signatureAlgorithm());
    signature.initSign(key);
    signature.update(probe);
    byte[] signed = signature.sign();
    signature.initVerify(certificate);
    signature.update(probe);
    return key.getAlgorithm().equals(certificate.getPublicKey().getAlgorithm())
        && signature.verify(signed);
  }

  private String signatureAlgorithm() {
    return switch (key.getAlgorithm()) {
      case "EC" -> "SHA256withECDSA";
      case "RSA" -> "SHA256withRSA";
      default -> key.getAlgorithm();
    };
  }
}
