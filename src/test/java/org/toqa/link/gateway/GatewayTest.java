package org.toqa.link.gateway;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.slf4j.LoggerFactory;
import org.toqa.link.gateway.GatewayException.Reason;
import org.toqa.link.message.GatewayMessage.Gateway;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.trust.HandshakeException;
import org.toqa.link.trust.LinkSocket;
import org.toqa.link.trust.LinkTls;
import org.toqa.testbed.LogLevel;

/** A server's port and a gateway, with robots that the test plays by hand. */
@Timeout(60)
class GatewayTest {
  private static final Duration LIMIT = Duration.ofSeconds(5);

  /** More than the buffers of all sockets on the way take. */
  private static final long FAR_TOO_MUCH = 256L << 20;

  @TempDir private Path folder;
  private final List<Socket> accepted = new ArrayList<>();
  private ServerSocket robot;
  private GatewayRig rig;

  @BeforeEach
  void start() throws IOException {
    robot = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    robot.setSoTimeout(10_000);
    rig = new GatewayRig(folder, List.of("127.0.0.0/8:" + robot.getLocalPort()));
  }

  @AfterEach
  void close() throws IOException {
    rig.close();
    robot.close();
    for (Socket socket : accepted) {
      socket.close();
    }
  }

  @Test
  void bytesArriveWholeAndInOrderBothWays() throws Exception {
    Random random = new Random(Long.getLong("toqa.seed", 1));
    byte[] sent = new byte[300_000 + random.nextInt(100_000)];
    random.nextBytes(sent);
    try (LinkSocket link = open()) {
      Socket end = accept();
      Thread echo = Thread.startVirtualThread(() -> echo(end));
      Thread writer = Thread.startVirtualThread(() -> writeInPieces(link, sent, random));
      byte[] received = new DataInputStream(link.in()).readNBytes(sent.length);
      writer.join();

      assertArrayEquals(sent, received);
      link.endOutput();
      assertEquals(-1, link.in().read(), "and its end arrives");
      echo.join();
    }
  }

  @Test
  void whoDoesNotReadHoldsUpNobodyElseAndWhoWritesToHim() throws Exception {
    LinkSocket slow = open();
    accept(); // and never read
    AtomicLong written = new AtomicLong();
    Thread writer = Thread.startVirtualThread(() -> writeUntilClosed(slow, written));
    long before = -1;
    while (before != written.get()) { // until there is no room on the way
      before = written.get();
      LockSupport.parkNanos(200_000_000);
    }
    assertTrue(written.get() < FAR_TOO_MUCH, "it waits: " + written);

    try (LinkSocket other = open()) {
      Socket end = accept();
      Thread.startVirtualThread(() -> echo(end));
      other.out().write(new byte[] {1, 2, 3});
      assertArrayEquals(new byte[] {1, 2, 3}, other.in().readNBytes(3));
    }
    slow.close();
    writer.join();
  }

  @Test
  void oneEndsCloseIsTheOthers() throws Exception {
    try (LinkSocket link = open()) {
      accept().close();
      assertEquals(-1, link.in().read());
    }
    LinkSocket link = open();
    Socket end = accept();
    link.close();
    assertEquals(-1, end.getInputStream().read());
  }

  @Test
  void whatCannotBeReachedIsToldWithTheReason() throws Exception {
    assertEquals(Reason.NOT_ALLOWED, refusal("127.0.0.1", robot.getLocalPort() ^ 1));
    assertEquals(Reason.HOST_NOT_KNOWN, refusal("no-such-host.invalid", robot.getLocalPort()));
    int port = robot.getLocalPort();
    robot.close();
    assertEquals(Reason.CANNOT_BE_REACHED, refusal("127.0.0.1", port));
    assertEquals(
        Reason.UNKNOWN_GATEWAY,
        assertThrows(GatewayException.class, () -> rig.port().open("yard", "127.0.0.1", port))
            .reason());
  }

  @Test
  void whatIsAskedForAgainAndAgainInVainIsLoggedOnce() {
    Logger logger = (Logger) LoggerFactory.getLogger(CarriedLinks.class);
    ListAppender<ILoggingEvent> lines = new ListAppender<>();
    lines.start();
    logger.addAppender(lines);
    try (LogLevel _ = LogLevel.usual(CarriedLinks.class.getName())) {
      for (int i = 0; i < 3; i++) {
        assertEquals(Reason.NOT_ALLOWED, refusal("127.0.0.1", robot.getLocalPort() ^ 1));
      }
    } finally {
      logger.detachAppender(lines);
    }
    assertEquals(1, lines.list.size(), lines.list.toString());
  }

  @Test
  void aCutLineEndsAllLinksAndTheGatewayDialsAgain() throws Exception {
    LinkSocket link = open();
    Socket end = accept();
    rig.cable().cut();

    assertEquals(-1, end.getInputStream().read(), "the robot is told at once");
    assertThrows(IOException.class, () -> endOrThrow(link));
    GatewayRig.await(() -> !rig.port().states().getFirst().isConnected());
    assertEquals(Reason.GATEWAY_NOT_CONNECTED, refusal("127.0.0.1", robot.getLocalPort()));

    rig.cable().mend();
    GatewayRig.await(() -> rig.port().states().getFirst().isConnected());
    open().close();
  }

  @Test
  void aNewerConnectionOfAGatewayReplacesTheOlder() throws Exception {
    LinkSocket link = open();
    Socket end = accept();
    try (LinkSocket newer = connect(rig.gateway())) {
      newer.out().write(LinkCodec.encode(new Gateway(1)));
      assertEquals(-1, end.getInputStream().read(), "what the older one carried has ended");
    }
    link.close();
    GatewayRig.await(() -> rig.port().states().getFirst().isConnected()); // by itself
  }

  @Test
  void strangersAreCutAndDoNotKeepTheGatewayOut() throws Exception {
    try (LinkSocket stranger = connect(GatewayRig.identity(folder, "stranger"))) {
      IOException e = assertThrows(IOException.class, () -> endOrThrow(stranger));
      assertEquals(HandshakeException.Reason.REJECTED_BY_PEER, LinkTls.reasonOf(e));
    }

    List<Socket> crowd = new ArrayList<>();
    for (int i = 0; i < 200; i++) { // each says nothing
      crowd.add(new Socket(InetAddress.getLoopbackAddress(), rig.port().port()));
    }
    Socket shouting = new Socket(InetAddress.getLoopbackAddress(), rig.port().port());
    shouting.getOutputStream().write("GET / HTTP/1.1\r\n\r\n".getBytes(StandardCharsets.UTF_8));
    assertEquals(-1, shouting.getInputStream().read());
    assertEquals(-1, crowd.getFirst().getInputStream().read(), "only some may wait");
    open().close();
    for (Socket socket : crowd) {
      socket.close();
    }
  }

  @Test
  void aGatewayThatSaysNonsenseIsCut() throws Exception {
    for (String first : List.of("{}\n", "x".repeat(1_000), "{\"type\":\"ping\"}\n")) {
      try (LinkSocket link = connect(rig.gateway())) {
        link.out().write(first.getBytes(StandardCharsets.UTF_8));
        assertThrows(IOException.class, () -> endOrThrow(link));
      }
    }
    try (LinkSocket link = connect(rig.gateway())) { // a stream that nobody asked for
      link.out().write("{\"type\":\"stream\",\"stream\":99}\n".getBytes(StandardCharsets.UTF_8));
      assertThrows(IOException.class, () -> endOrThrow(link));
    }
    try (LinkSocket link = connect(rig.gateway())) {
      link.out().write(LinkCodec.encode(new Gateway(1)));
      link.out().write("nonsense\n".getBytes(StandardCharsets.UTF_8));
      assertThrows(IOException.class, () -> endOrThrow(link));
    }
  }

  @Test
  void aGatewayTrustsNoOtherServer() throws Exception {
    try (ServerSocket other = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
        GatewayAgent _ = rig.dial(other.getLocalPort(), rig.gateway(), List.of("127.0.0.1"))) {
      LinkTls tls = GatewayRig.identity(folder, "other");
      HandshakeException e =
          assertThrows(
              HandshakeException.class,
              () -> tls.acceptGateway(other.accept(), (_, _) -> true, LIMIT).close());
      assertEquals(HandshakeException.Reason.REJECTED_BY_PEER, e.reason());
    }
  }

  private LinkSocket open() throws GatewayException {
    return rig.port().open("dock", "127.0.0.1", robot.getLocalPort());
  }

  private Reason refusal(String host, int port) {
    return assertThrows(GatewayException.class, () -> rig.port().open("dock", host, port)).reason();
  }

  private Socket accept() throws IOException {
    Socket socket = robot.accept();
    accepted.add(socket);
    return socket;
  }

  /** As a gateway does. */
  private LinkSocket connect(LinkTls as) throws IOException {
    return as.connect(
        new Socket(InetAddress.getLoopbackAddress(), rig.port().port()),
        LinkTls.GATEWAY,
        (peer, _) -> peer.equals(rig.server().fingerprint()),
        LIMIT);
  }

  /**
   * Reads what still comes.
   *
   * @throws IOException always: how the connection ended
   */
  private static void endOrThrow(LinkSocket link) throws IOException {
    var _ = link.in().readAllBytes();
    throw new IOException("it ended");
  }

  private static void echo(Socket end) {
    try {
      end.getInputStream().transferTo(end.getOutputStream());
      end.shutdownOutput();
    } catch (IOException e) {
      // the other end has gone
    }
  }

  private static void writeInPieces(LinkSocket link, byte[] all, Random random) {
    try {
      OutputStream out = link.out();
      for (int at = 0; at < all.length; ) {
        int end = Math.min(all.length, at + 1 + random.nextInt(40_000));
        out.write(Arrays.copyOfRange(all, at, end));
        at = end;
      }
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private static void writeUntilClosed(LinkSocket link, AtomicLong written) {
    byte[] piece = new byte[64 * 1024];
    try {
      while (written.get() < FAR_TOO_MUCH) {
        link.out().write(piece);
        written.addAndGet(piece.length);
      }
    } catch (IOException e) {
      // it was closed
    }
  }
}
