package org.toqa.accounts;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.HexFormat;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * 256 random bits that are known to their holder alone. Of the ones that are stored the table has
 * only the SHA-256, which needs no salt or stretching for a secret of that size.
 */
public final class Secret {
  private static final int SECRET_BYTES = 32;
  private static final String SITE_END = ".";
  private static final Pattern OF_SITE = Pattern.compile("([1-9][0-9]{0,8})\\..*");
  private static final Pattern WELL_FORMED =
      Pattern.compile("(?:[1-9][0-9]{0,8}\\.)?[A-Za-z0-9_-]{43}");
  private static final SecureRandom RANDOM = new SecureRandom();

  private Secret() {}

  /** 43 characters that may be in an address, a cookie and a header. */
  public static String random() {
    byte[] secret = new byte[SECRET_BYTES];
    RANDOM.nextBytes(secret);
    return Base64.getUrlEncoder().withoutPadding().encodeToString(secret);
  }

  /** The same, which tells of which site it is: {@code 2.} and 43 characters. */
  public static String random(long site) {
    return site == Site.FIRST_ID ? random() : site + SITE_END + random();
  }

  /** The id of the site that the secret says it is of, whether there is one or not. */
  public static long site(String secret) {
    Matcher matcher = OF_SITE.matcher(secret);
    return matcher.matches() ? Long.parseLong(matcher.group(1)) : Site.FIRST_ID;
  }

  /** Whether it may be one of these, of any site. */
  public static boolean isWellFormed(String secret) {
    return WELL_FORMED.matcher(secret).matches();
  }

  /** SHA-256, hex. */
  public static String hash(String secret) {
    try {
      byte[] digest =
          MessageDigest.getInstance("SHA-256").digest(secret.getBytes(StandardCharsets.UTF_8));
      return HexFormat.of().formatHex(digest);
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError("Every Java has SHA-256.", e);
    }
  }
}
