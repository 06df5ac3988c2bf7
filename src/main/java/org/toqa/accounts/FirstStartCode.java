package org.toqa.accounts;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * What the page of the first start asks for: only who sees the server's own words may make the
 * first manager. Another one at each start of the server.
 *
 * @param text as it is printed
 */
public record FirstStartCode(String text) {
  /** Without what is easily taken for another. */
  private static final String CHARACTERS = "ABCDEFGHJKMNPQRSTUVWXYZ23456789";

  private static final int LENGTH = 12;
  private static final int GROUP = 4;

  /** 59 bits: more than can be tried. */
  public static FirstStartCode random() {
    return new FirstStartCode(
        new SecureRandom()
            .ints(LENGTH, 0, CHARACTERS.length())
            .mapToObj(index -> String.valueOf(CHARACTERS.charAt(index)))
            .collect(Collectors.joining())
            .replaceAll("(.{" + GROUP + "})(?!$)", "$1-"));
  }

  /** In any case, with or without what stands between its groups. */
  public boolean isSame(String given) {
    return MessageDigest.isEqual(bytes(text), bytes(given));
  }

  private static byte[] bytes(String code) {
    return code.toUpperCase(Locale.ROOT)
        .replaceAll("[^A-Z0-9]", "")
        .getBytes(StandardCharsets.UTF_8);
  }

  /** Without the code. */
  @Override
  public String toString() {
    return "FirstStartCode[]";
  }
}
