package org.toqa.link.http;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * What a server proves itself by to a robot that takes commands over HTTP: a bearer token (RFC
 * 6750). It is neither shown nor logged.
 *
 * @param secret {@value #FEWEST} to {@value #MOST} letters, digits and {@code -._~+/=}
 */
public record RobotToken(String secret) {
  private static final int FEWEST = 16;
  private static final int MOST = 128;
  private static final Pattern SECRET =
      Pattern.compile("[A-Za-z0-9._~+/=-]{" + FEWEST + "," + MOST + "}");

  private static final int RANDOM_BYTES = 24;

  /**
   * @throws IllegalArgumentException if it is none, without saying it
   */
  public RobotToken {
    if (!SECRET.matcher(secret).matches()) {
      throw new IllegalArgumentException("That is not the token of a robot.");
    }
  }

  /** Empty where the text is no token. */
  public static Optional<RobotToken> parse(String text) {
    return SECRET.matcher(text).matches() ? Optional.of(new RobotToken(text)) : Optional.empty();
  }

  /** One that nobody guesses. */
  public static RobotToken random() {
    byte[] bytes = new byte[RANDOM_BYTES];
    new SecureRandom().nextBytes(bytes);
    return new RobotToken(Base64.getUrlEncoder().withoutPadding().encodeToString(bytes));
  }

  /** The value of the header {@code Authorization}. */
  String authorization() {
    return "Bearer " + secret;
  }

  /** Whether the header's value is this token's; takes as long whatever is wrong. */
  public boolean isIn(String authorization) {
    return MessageDigest.isEqual(
        authorization().getBytes(StandardCharsets.US_ASCII),
        authorization.getBytes(StandardCharsets.UTF_8));
  }

  @Override
  public String toString() {
    return "RobotToken[...]";
  }
}
