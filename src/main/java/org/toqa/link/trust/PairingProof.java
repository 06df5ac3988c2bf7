package org.toqa.link.trust;

import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.Locale;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;

/**
 * How the two ends of a pairing show each other that they know the secret of the code, without
 * telling it: HMAC-SHA256 over who they are, with the secret as the key. TLS has proved on this
 * very connection that each has the key of its certificate, so a proof is worth nothing to anybody
 * who overhears it or whom it was not made for.
 */
public enum PairingProof {
  SERVER,
  ROBOT;

  private static final String MAC = "HmacSHA256";

  /** The proof, 64 hexadecimal digits in lower case. */
  public String of(PairingCode code, Fingerprint robot, Fingerprint server) {
    String statement =
        "%s %s %s %s".formatted(LinkTls.PAIRING, name().toLowerCase(Locale.ROOT), robot, server);
    try {
      Mac mac = Mac.getInstance(MAC);
      mac.init(new SecretKeySpec(code.secret(), MAC));
      return HexFormat.of().formatHex(mac.doFinal(statement.getBytes(StandardCharsets.US_ASCII)));
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("Every Java has HMAC-SHA256.", e);
    }
  }

  /** Whether this is the proof; how long the answer takes tells nothing. */
  public boolean isValid(String given, PairingCode code, Fingerprint robot, Fingerprint server) {
    return MessageDigest.isEqual(
        given.getBytes(StandardCharsets.UTF_8),
        of(code, robot, server).getBytes(StandardCharsets.UTF_8));
  }
}
