package org.toqa.notices;

import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.SecureRandom;
import java.util.Base64;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;

/**
 * What signs the requests to a webhook, by the specification Standard Webhooks: the header {@code
 * webhook-signature} has HMAC-SHA256 of {@code id.stamp.body}, base64, with the version before it.
 *
 * @param text {@code whsec_} and the key, base64
 */
public record WebhookSecret(String text) {
  private static final String PREFIX = "whsec_";
  private static final String ALGORITHM = "HmacSHA256";
  private static final int BYTES = 32;
  private static final SecureRandom RANDOM = new SecureRandom();

  public static WebhookSecret random() {
    byte[] key = new byte[BYTES];
    RANDOM.nextBytes(key);
    return new WebhookSecret(PREFIX + Base64.getEncoder().encodeToString(key));
  }

  /**
   * The value of the header {@code webhook-signature}.
   *
   * @param id of the message, the same each time it is tried
   * @param stamp when it is sent, seconds since 1970
   */
  public String signature(String id, long stamp, String body) {
    try {
      Mac mac = Mac.getInstance(ALGORITHM);
      mac.init(
          new SecretKeySpec(
              Base64.getDecoder().decode(text.substring(PREFIX.length())), ALGORITHM));
      byte[] signed = (id + "." + stamp + "." + body).getBytes(StandardCharsets.UTF_8);
      return "v1," + Base64.getEncoder().encodeToString(mac.doFinal(signed));
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException(e); // every Java has it
    }
  }

  /** Without the key, so that it reaches no log. */
  @Override
  public String toString() {
    return "WebhookSecret[]";
  }
}
