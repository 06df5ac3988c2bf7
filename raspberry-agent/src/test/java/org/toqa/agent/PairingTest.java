package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.config.AgentConfig;
import org.toqa.agent.config.ChassisConfig;
import org.toqa.link.PairingResult;
import org.toqa.link.PairingResult.Paired;
import org.toqa.link.PairingResult.Refused;
import org.toqa.link.RobotAddress;
import org.toqa.link.TcpRobotLinkFactory;
import org.toqa.link.message.DecodeResult.Decoded;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.message.PairingMessage.Pair;
import org.toqa.link.message.PairingMessage.Unpaired;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkSocket;
import org.toqa.link.trust.LinkTls;
import org.toqa.link.trust.PairingCode;
import org.toqa.link.trust.PairingProof;
import org.toqa.link.trust.TimeLimit;
import org.toqa.motion.DriveKind;
import org.toqa.wording.Sentence;

/**
 * A real daemon that shows a code, and those who try to pair with it, while the clock does not
 * advance.
 */
@Timeout(60)
class PairingTest {

  private static final Duration LIMIT = Duration.ofSeconds(5);

  /** Ends a test whose daemon neither speaks nor closes: reading cannot be interrupted. */
  private static final Duration PATIENCE = Duration.ofSeconds(30);

  @TempDir Path folder;
  private LinkTls server;
  private LinkTls other;
  private @Nullable Daemon daemon;
  private long nanos;

  @BeforeEach
  void open() throws IOException {
    server = tls("server");
    other = tls("other");
    start(true);
  }

  @AfterEach
  void close() throws IOException {
    daemon().close();
  }

  private Daemon daemon() {
    return Objects.requireNonNull(daemon);
  }

  private LinkTls tls(String name) throws IOException {
    return new LinkTls(IdentityFile.open(Files.createDirectories(folder.resolve(name))));
  }

  private void start(boolean pair) throws IOException {
    start(InetAddress.getLoopbackAddress(), false, pair);
  }

  private void start(InetAddress address, boolean plainOffLoopback, boolean pair)
      throws IOException {
    AgentConfig config =
        new AgentConfig(
            "r1",
            address,
            0,
            plainOffLoopback,
            folder.resolve("robot"),
            5,
            0.255,
            DriveKind.OMNI,
            Rig.LIMITS,
            AgentConfig.Following.DEFAULT,
            new ChassisConfig.Simulated(Rig.START, SimulatedBattery.FULL, 0, 1, 1));
    daemon = Daemon.open(config, () -> Instant.EPOCH, nanos, pair);
  }

  private void restart(boolean pair) throws IOException {
    daemon().close();
    start(pair);
  }

  private PairingResult pair(LinkTls who, String code) {
    return new TcpRobotLinkFactory(who, false)
        .pair(
            new RobotAddress("r1", "127.0.0.1", daemon().port(), null),
            PairingCode.parse(code).orElseThrow());
  }

  private String code() {
    return daemon().pairingCode().orElseThrow();
  }

  /** The robot's part is right, the secret is not. */
  private String wrongCode() {
    String code = code();
    char last = code.charAt(code.length() - 1);
    return code.substring(0, code.length() - 1) + (last == 'A' ? 'B' : 'A');
  }

  private void refused(String sentence, PairingResult result) {
    assertEquals(sentence, assertInstanceOf(Refused.class, result).sentence().english());
    assertTrue(Files.notExists(folder.resolve("robot").resolve("server.pin")));
  }

  @Test
  void codePairsAndTheSameServerMayRepeatIt() {
    Paired first = assertInstanceOf(Paired.class, pair(server, code()));

    assertEquals(first, pair(server, code()));
  }

  @Test
  void secondServerCannotUseTheCodeToo() {
    assertInstanceOf(Paired.class, pair(server, code()));

    assertEquals(
        new Refused(
            Sentence.verbatim(
                "The code was used by another server; start the robot's daemon with --pair for a new"
                    + " one.")),
        pair(other, code()));
  }

  @Test
  void wrongCodeMayBeTriedFiveTimesAndThenTheRightOneIsVoidToo() {
    for (int left = 4; left > 0; left--) {
      refused("The code is wrong; tries left: " + left + ".", pair(server, wrongCode()));
    }
    refused(
        "The code is wrong, and void after 5 wrong tries; start the robot's daemon with --pair for"
            + " a new one.",
        pair(server, wrongCode()));
    refused(
        "The code is void after 5 wrong tries; start the robot's daemon with --pair for a new one.",
        pair(server, code()));
  }

  @Test
  void wrongTriesOfAnotherServerVoidNothing() {
    for (int i = 0; i < 6; i++) {
      assertInstanceOf(Refused.class, pair(other, wrongCode()));
    }

    assertInstanceOf(Paired.class, pair(server, code()));
  }

  @Test
  void codeRunsOutAfterTenMinutes() {
    nanos += Duration.ofMinutes(10).plusSeconds(1).toNanos();
    daemon().tick(nanos);

    refused(
        "The code has run out after 10 minutes; start the robot's daemon with --pair for a new"
            + " one.",
        pair(server, code()));
  }

  @Test
  void codeOfAnotherRobotIsNotEvenTried() throws IOException {
    String robots = PairingCode.of(other.fingerprint(), new SecureRandom()).text();
    refused(
        "The code does not belong to the device at 127.0.0.1:%d. Check the code, address and port."
            .formatted(daemon().port()),
        pair(server, robots));

    for (int left = 4; left > 0; left--) { // all tries are still there
      refused("The code is wrong; tries left: " + left + ".", pair(server, wrongCode()));
    }
  }

  @Test
  void pairedRobotShowsNoCodeUnlessItIsAsked() throws IOException {
    String code = code();
    assertInstanceOf(Paired.class, pair(server, code));
    restart(false);

    assertTrue(daemon().pairingCode().isEmpty());
    assertEquals(
        new Refused(Sentence.verbatim("r1 shows no code; start its daemon with --pair.")),
        pair(other, code));
  }

  @Test
  void newRobotOffLoopbackShowsACodeByItselfUnlessItMayDoWithoutEncryption() throws IOException {
    InetAddress everywhere = InetAddress.getByName("0.0.0.0");
    daemon().close();
    start(everywhere, true, false);
    assertTrue(daemon().pairingCode().isEmpty());

    daemon().close();
    start(everywhere, false, false);
    assertInstanceOf(Paired.class, pair(server, code()));

    daemon().close();
    start(everywhere, true, false); // paired is paired: it does not go back to plain text
    assertEquals(
        new Refused(Sentence.verbatim("r1 shows no code; start its daemon with --pair.")),
        pair(server, PairingCode.of(fingerprint(), new SecureRandom()).text()));
  }

  private Fingerprint fingerprint() throws IOException {
    return IdentityFile.open(folder.resolve("robot")).fingerprint();
  }

  @Test
  void oldCodeIsNothingAfterANewOneIsShown() throws IOException {
    String old = code();
    restart(true);

    refused("The code is wrong; tries left: 4.", pair(server, old));
  }

  @Test
  void proofOfTheServerIsWorthNothingToAnotherOne() throws IOException {
    Fingerprint robot = assertInstanceOf(Paired.class, pair(server, code())).robot();
    PairingCode code = PairingCode.parse(code()).orElseThrow();
    String overheard = PairingProof.SERVER.of(code, robot, server.fingerprint());

    assertEquals(new Unpaired("The code is wrong; tries left: 4."), say(other, overheard));
  }

  private Object say(LinkTls who, String proof) throws IOException {
    try (LinkSocket link = pairing(who)) {
      link.out().write(LinkCodec.encode(new Pair(null, proof)));
      LineReader.Line answer = new LineReader(link.in()).readLine();
      return assertInstanceOf(
              Decoded.class, LinkCodec.decodePairingMessage(Objects.requireNonNull(answer)))
          .message();
    }
  }

  private LinkSocket pairing(LinkTls who) throws IOException {
    return who.connect(socket(), LinkTls.PAIRING, (_, _) -> true, LIMIT);
  }

  private Socket socket() throws IOException {
    return new Socket(InetAddress.getLoopbackAddress(), daemon().port());
  }

  @Test
  void pairingThatIsCutOffChangesNothing() throws IOException {
    pairing(server).close();
    try (LinkSocket link = pairing(server)) {
      link.out().write("{\"type\":\"pair\",\"pro".getBytes(StandardCharsets.UTF_8));
    }

    assertInstanceOf(Paired.class, pair(server, code()));
  }

  @Test
  void silentConnectionsKeepNobodyOut() throws IOException {
    List<Socket> silent = new ArrayList<>();
    for (int i = 0; i < 40; i++) {
      silent.add(socket());
    }

    assertInstanceOf(Paired.class, pair(server, code()));
    for (Socket socket : silent) {
      socket.close();
    }
  }

  @Test
  void robotOfAnotherNameIsNotTakenAndStaysWithItsServer() throws IOException {
    Fingerprint robot = assertInstanceOf(Paired.class, pair(other, code())).robot();
    restart(true);

    PairingResult result =
        new TcpRobotLinkFactory(server, false)
            .pair(
                new RobotAddress("r2", "127.0.0.1", daemon().port(), null),
                PairingCode.parse(code()).orElseThrow());

    assertEquals(new Refused(Sentence.verbatim("The robot here is called r1, not r2.")), result);
    try (LinkSocket before =
        other.connect(socket(), LinkTls.LINK, (peer, _) -> peer.equals(robot), LIMIT)) {
      daemonGreets(before);
    }
  }

  @Test
  void serverOfBeforeIsNotHeardOnceAnotherIsPaired() throws IOException {
    Fingerprint robot = assertInstanceOf(Paired.class, pair(server, code())).robot();
    restart(true);
    try (LinkSocket before =
        server.connect(socket(), LinkTls.LINK, (peer, _) -> peer.equals(robot), LIMIT)) {
      daemonGreets(before);
      assertInstanceOf(Paired.class, pair(other, code()));
      tickUntilClosed(before);
    }
  }

  private void daemonGreets(LinkSocket link) throws IOException {
    LineReader lines = new LineReader(link.in());
    Thread ticks = Thread.startVirtualThread(this::tickOften);
    try (TimeLimit _ = link.startTimeLimit(PATIENCE)) {
      assertTrue(lines.readLine() instanceof LineReader.Text, "no hello");
    } finally {
      ticks.interrupt();
      join(ticks);
    }
  }

  private void tickUntilClosed(LinkSocket link) throws IOException {
    Thread ticks = Thread.startVirtualThread(this::tickOften);
    try (TimeLimit patience = link.startTimeLimit(PATIENCE)) {
      readToItsEnd(link);
      assertFalse(patience.hasPassed(), "it is still heard");
    } finally {
      ticks.interrupt();
      join(ticks);
    }
  }

  private static void readToItsEnd(LinkSocket link) {
    try {
      link.in().readAllBytes();
    } catch (IOException e) {
      // cut off without the farewell of TLS: the same end
    }
  }

  private void tickOften() {
    while (!Thread.currentThread().isInterrupted()) {
      daemon().tick(nanos);
      LockSupport.parkNanos(1_000_000);
    }
  }

  private static void join(Thread thread) {
    try {
      thread.join();
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }
}
