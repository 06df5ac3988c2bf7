package org.toqa.link.trust;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.security.SecureRandom;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.Properties;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.link.message.DecodeResult.Decoded;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.message.PairingMessage;
import org.toqa.link.message.PairingMessage.Pair;
import org.toqa.link.message.PairingMessage.Paired;
import org.toqa.link.message.PairingMessage.Unpaired;

/** The code and the proofs of {@code pairing.golden}, which were computed without this code. */
class PairingGoldenTest {

  private static final Properties GOLDEN = new Properties();

  @BeforeAll
  static void read() throws IOException {
    try (Reader reader =
        new InputStreamReader(
            Objects.requireNonNull(PairingGoldenTest.class.getResourceAsStream("pairing.golden")),
            StandardCharsets.UTF_8)) {
      GOLDEN.load(reader);
    }
  }

  private static Fingerprint fingerprint(String key) {
    return new Fingerprint(GOLDEN.getProperty(key));
  }

  private static PairingCode code() {
    return PairingCode.parse(GOLDEN.getProperty("code")).orElseThrow();
  }

  @Test
  void codeNamesTheRobotAndNobodyElse() {
    assertTrue(code().isOf(fingerprint("robot")));
    assertFalse(code().isOf(fingerprint("server")));
    assertEquals(GOLDEN.getProperty("code"), code().text());
  }

  @Test
  void newCodesDifferInTheirSecretsOnly() {
    SecureRandom random = new SecureRandom();
    String first = PairingCode.of(fingerprint("robot"), random).text();
    String second = PairingCode.of(fingerprint("robot"), random).text();

    String robotsPart = GOLDEN.getProperty("code").substring(0, "AAAA-BBBB-CCCC-DDDD-".length());
    assertTrue(first.startsWith(robotsPart), first);
    assertTrue(second.startsWith(robotsPart), second);
    assertNotEquals(first, second);
  }

  @Test
  void codeIsReadHoweverItIsTyped() {
    String typed = GOLDEN.getProperty("code").toLowerCase(Locale.ROOT).replace("-", "  ");

    assertEquals(GOLDEN.getProperty("code"), PairingCode.parse(typed).orElseThrow().text());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "AAAA-BBBB-CCCC-DDDD-EEEEE-FFFF",
        "AAAA-BBBB-CCCC-DDDD-EEEEE-FFFFFF",
        "AAAA-BBBB-CCCC-DDDD-EEEEE-FFFF1",
        "AAAA-BBBB-CCCC-DDDD-EEEEE-FFFFÄ"
      })
  void whatIsNoCodeIsRefused(String typed) {
    assertEquals(Optional.empty(), PairingCode.parse(typed));
  }

  @Test
  void secretIsNotInTheLog() {
    String secret = GOLDEN.getProperty("code").replace("-", "").substring(16);

    assertFalse(code().toString().contains(secret), code().toString());
  }

  @Test
  void proofsAreThoseOfTheFile() {
    Pair pair = assertInstanceOf(Pair.class, message("pair"));
    Paired paired = assertInstanceOf(Paired.class, message("paired"));
    Fingerprint robot = fingerprint("robot");
    Fingerprint server = fingerprint("server");

    assertEquals(pair.proof(), PairingProof.SERVER.of(code(), robot, server));
    assertEquals(paired.proof(), PairingProof.ROBOT.of(code(), robot, server));
    assertTrue(PairingProof.SERVER.isValid(pair.proof(), code(), robot, server));
    assertFalse(PairingProof.ROBOT.isValid(pair.proof(), code(), robot, server));
    assertFalse(PairingProof.SERVER.isValid(pair.proof(), code(), robot, robot));
  }

  @Test
  void messagesAreThoseOfTheFile() {
    assertInstanceOf(Unpaired.class, message("unpaired"));
    for (String type : new String[] {"pair", "paired", "unpaired"}) {
      assertEquals(
          GOLDEN.getProperty(type) + "\n",
          new String(LinkCodec.encode(message(type)), StandardCharsets.UTF_8));
    }
  }

  private static PairingMessage message(String key) {
    byte[] line = GOLDEN.getProperty(key).getBytes(StandardCharsets.UTF_8);
    Decoded<?> read =
        assertInstanceOf(Decoded.class, LinkCodec.decodePairingMessage(new LineReader.Text(line)));
    return (PairingMessage) read.message();
  }
}
