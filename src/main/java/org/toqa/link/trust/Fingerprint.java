package org.toqa.link.trust;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.security.cert.CertificateEncodingException;
import java.security.cert.X509Certificate;
import java.util.HexFormat;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * What an end of the link is known by: SHA-256 over its certificate in DER.
 *
 * @param hex 64 digits, lower case
 */
public record Fingerprint(String hex) {

  private static final Pattern HEX = Pattern.compile("[0-9a-f]{64}");

  /**
   * @throws IllegalArgumentException if it is not 64 digits 0-9a-f
   */
  public Fingerprint {
    if (!HEX.matcher(hex).matches()) {
      throw new IllegalArgumentException("A fingerprint has 64 digits 0-9a-f, not: " + hex);
    }
  }

  /** Empty where the text is no fingerprint. */
  public static Optional<Fingerprint> parse(String text) {
    return HEX.matcher(text).matches() ? Optional.of(new Fingerprint(text)) : Optional.empty();
  }

  static Fingerprint of(X509Certificate certificate) throws CertificateEncodingException {
    try {
      byte[] digest = MessageDigest.getInstance("SHA-256").digest(certificate.getEncoded());
      return new Fingerprint(HexFormat.of().formatHex(digest));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("Every Java has SHA-256.", e);
    }
  }

  @Override
  public String toString() {
    return hex;
  }
}
