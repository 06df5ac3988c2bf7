package org.toqa.link.trust;

import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.security.SecureRandom;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * What a robot shows and a person types in at the server: 26 characters of Base32 (RFC 4648). The
 * first 16 are the first 80 bits of the fingerprint of the robot's certificate, the other 10 are a
 * secret of 50 bits that is good once.
 */
public final class PairingCode {

  private static final String ALPHABET = "ABCDEFGHIJKLMNOPQRSTUVWXYZ234567";
  private static final int BITS_A_LETTER = 5;
  private static final int FINGERPRINT_LETTERS = 16;
  private static final int SECRET_LETTERS = 10;
  private static final int FINGERPRINT_BITS = 256;
  private static final Pattern LETTERS = Pattern.compile("[A-Z2-7]{26}");

  private final String letters;

  private PairingCode(String letters) {
    this.letters = letters;
  }

  /** A new code of the robot with this certificate. */
  public static PairingCode of(Fingerprint robot, SecureRandom random) {
    BigInteger secret = new BigInteger(BITS_A_LETTER * SECRET_LETTERS, random);
    return new PairingCode(fingerprintLetters(robot) + base32(secret, SECRET_LETTERS));
  }

  /** Reads what a person has typed; blanks and hyphens do not count, nor does case. */
  public static Optional<PairingCode> parse(String typed) {
    String letters = typed.replaceAll("[\\s-]", "").toUpperCase(Locale.ROOT);
    return LETTERS.matcher(letters).matches()
        ? Optional.of(new PairingCode(letters))
        : Optional.empty();
  }

  /** Whether the code is one of the robot with this certificate. */
  public boolean isOf(Fingerprint robot) {
    return letters.startsWith(fingerprintLetters(robot));
  }

  /** The secret's letters as ASCII. */
  byte[] secret() {
    return letters.substring(FINGERPRINT_LETTERS).getBytes(StandardCharsets.US_ASCII);
  }

  /** As it is shown to people, with hyphens: four groups of four, two of five. */
  public String text() {
    return letters.replaceFirst("(.{4})(.{4})(.{4})(.{4})(.{5})(.{5})", "$1-$2-$3-$4-$5-$6");
  }

  @Override
  public String toString() {
    return "PairingCode[" + letters.substring(0, FINGERPRINT_LETTERS) + "...]";
  }

  private static String fingerprintLetters(Fingerprint robot) {
    int bits = BITS_A_LETTER * FINGERPRINT_LETTERS;
    return base32(
        new BigInteger(robot.hex(), 16).shiftRight(FINGERPRINT_BITS - bits), FINGERPRINT_LETTERS);
  }

  private static String base32(BigInteger bits, int length) {
    StringBuilder text = new StringBuilder();
    for (int i = length - 1; i >= 0; i--) {
      int letter = bits.shiftRight(BITS_A_LETTER * i).intValue() & (ALPHABET.length() - 1);
      text.append(ALPHABET.charAt(letter));
    }
    return text.toString();
  }
}
