package org.toqa.link.trust;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.time.Duration;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLException;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.TrustManager;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.link.trust.HandshakeException.Reason;

/** Both ends of the encrypted link over real sockets, and others that try. */
@Timeout(30)
class LinkTlsTest {

  private static final Duration LIMIT = Duration.ofSeconds(5);

  @TempDir private Path folder;
  private ServerSocket listener;
  private Identity robotKey;
  private Identity serverKey;
  private Identity outsiderKey;
  private LinkTls robot;
  private LinkTls server;
  private LinkTls outsider;

  @BeforeEach
  void open() throws IOException {
    listener = new ServerSocket(0, 10, InetAddress.getLoopbackAddress());
    robotKey = identity("robot");
    serverKey = identity("server");
    outsiderKey = identity("outsider");
    robot = new LinkTls(robotKey);
    server = new LinkTls(serverKey);
    outsider = new LinkTls(outsiderKey);
  }

  @AfterEach
  void close() throws IOException {
    listener.close();
  }

  private Identity identity(String name) throws IOException {
    return IdentityFile.open(Files.createDirectory(folder.resolve(name)));
  }

  @Test
  void pinnedEndsKnowEachOtherAndTalk() throws IOException {
    CompletableFuture<LinkSocket> taken = accepted(LIMIT);
    try (LinkSocket made = connected(server, robot.fingerprint());
        LinkSocket met = taken.join()) {
      assertEquals(robot.fingerprint(), made.peer());
      assertEquals(server.fingerprint(), met.peer());
      made.out().write("ping".getBytes(StandardCharsets.US_ASCII));
      assertEquals("ping", new String(met.in().readNBytes(4), StandardCharsets.US_ASCII));
    }
  }

  @Test
  void outsiderWithACertificateOfItsOwnIsRefusedAndToldSo() throws IOException {
    CompletableFuture<LinkSocket> taken = accepted(LIMIT);
    try (LinkSocket made = connected(outsider, robot.fingerprint())) {
      IOException e = assertThrows(IOException.class, () -> made.in().read());
      assertEquals(Reason.REJECTED_BY_PEER, LinkTls.reasonOf(e));
    }
    assertEquals(Reason.UNTRUSTED_PEER, failure(taken));
  }

  @Test
  void robotWithAnotherKeyIsRefused() {
    CompletableFuture<LinkSocket> taken = accepted(LIMIT);
    HandshakeException e =
        assertThrows(
            HandshakeException.class, () -> connected(server, outsider.fingerprint()).close());

    assertEquals(Reason.UNTRUSTED_PEER, e.reason());
    assertEquals(Reason.REJECTED_BY_PEER, failure(taken));
  }

  @Test
  void robotThatStillSpeaksWhenItIsRefusedIsToldSo() throws IOException {
    Socket slow = new SlowSocket();
    slow.connect(listener.getLocalSocketAddress());
    CompletableFuture<LinkSocket> taken = accepted(() -> slow, LIMIT);
    Socket fast = listener.accept();
    HandshakeException e =
        assertThrows(
            HandshakeException.class,
            () -> server.connect(fast, LinkTls.LINK, (_, _) -> false, LIMIT).close());

    assertEquals(Reason.UNTRUSTED_PEER, e.reason());
    assertEquals(Reason.REJECTED_BY_PEER, failure(taken));
  }

  @Test
  void outsiderThatStillSpeaksWhenItIsRefusedIsToldSo() throws IOException {
    CompletableFuture<LinkSocket> taken = accepted(LIMIT);
    Socket slow = new SlowSocket();
    slow.connect(listener.getLocalSocketAddress());
    try (LinkSocket made = outsider.connect(slow, LinkTls.LINK, (_, _) -> true, LIMIT)) {
      IOException e = assertThrows(IOException.class, () -> made.in().read());
      assertEquals(Reason.REJECTED_BY_PEER, LinkTls.reasonOf(e));
    }
    assertEquals(Reason.UNTRUSTED_PEER, failure(taken));
  }

  @Test
  void peerWithoutACertificateIsRefused() throws Exception {
    CompletableFuture<LinkSocket> taken = accepted(LIMIT);
    try (SSLSocket bare = socket("TLSv1.3", null)) {
      assertThrows(SSLException.class, () -> bare.getInputStream().read());
    }
    assertTrue(taken.handle((link, e) -> e != null).join());
  }

  @Test
  void olderTlsIsRefusedEvenWithTheRightKey() throws Exception {
    CompletableFuture<LinkSocket> taken = accepted(LIMIT);
    try (SSLSocket old = socket("TLSv1.2", serverKey)) {
      assertThrows(SSLException.class, old::startHandshake);
    }
    assertEquals(Reason.FAILED, failure(taken));
  }

  @Test
  void plainTextIsRefused() throws IOException {
    CompletableFuture<LinkSocket> taken = accepted(LIMIT);
    try (Socket plain = tcp()) {
      plain
          .getOutputStream()
          .write("{\"type\":\"ping\",\"seq\":1}\n".getBytes(StandardCharsets.UTF_8));
      assertEquals(Reason.NOT_TLS, failure(taken));
    }
  }

  @Test
  void peerThatAnswersInPlainTextIsRefused() throws IOException {
    CompletableFuture<Void> plain =
        CompletableFuture.runAsync(
            () -> {
              try (Socket taken = listener.accept()) {
                taken
                    .getOutputStream()
                    .write("{\"type\":\"hello\"}\n".getBytes(StandardCharsets.UTF_8));
                taken.getInputStream().readAllBytes();
              } catch (IOException e) {
                // the server closes the connection
              }
            },
            Thread::startVirtualThread);
    HandshakeException e =
        assertThrows(
            HandshakeException.class, () -> connected(server, robot.fingerprint()).close());

    assertEquals(Reason.NOT_TLS, e.reason());
    plain.join();
  }

  @Test
  void connectionThatIsCutOffIsTold() throws IOException {
    CompletableFuture<LinkSocket> taken = accepted(LIMIT);
    tcp().close();

    assertEquals(Reason.CUT_OFF, failure(taken));
  }

  @Test
  void peerThatFeedsTheHandshakeSlowlyIsThrownOut() throws Exception {
    CompletableFuture<LinkSocket> taken = accepted(Duration.ofMillis(500));
    try (Socket slow = tcp()) {
      slow.getOutputStream()
          .write(new byte[] {22, 3, 1}); // a handshake begins, and goes no further
      assertEquals(Reason.TIMED_OUT, failure(taken));
      assertEquals(-1, slow.getInputStream().read());
    }
  }

  @Test
  void peerThatSaysNothingIsLate() throws IOException {
    Socket silent = tcp();
    silent.setSoTimeout(100);
    HandshakeException e =
        assertThrows(
            HandshakeException.class,
            () -> server.connect(silent, LinkTls.LINK, (_, _) -> true, LIMIT).close());

    assertEquals(Reason.TIMED_OUT, e.reason());
  }

  @Test
  @Timeout(15)
  void peerThatSpeaksOnWhenItIsRefusedIsHungUpOn() throws IOException {
    CompletableFuture<LinkSocket> taken = accepted(Duration.ofSeconds(25));
    try (Socket babbler = tcp()) {
      Thread.startVirtualThread(() -> babble(babbler));
      assertEquals(Reason.NOT_TLS, failure(taken));
    }
  }

  private static void babble(Socket babbler) {
    try {
      while (true) {
        babbler.getOutputStream().write('x');
        Thread.sleep(100);
      }
    } catch (IOException | InterruptedException e) {
      // the robot closes the connection
    }
  }

  @Test
  void recordedConnectionCannotBeReplayed() throws Exception {
    byte[] recorded = recordOfARightConnection();
    CompletableFuture<LinkSocket> taken = accepted(Duration.ofSeconds(2));
    try (Socket replay = tcp()) {
      replay.getOutputStream().write(recorded);
      assertTrue(taken.handle((link, e) -> e != null).join());
    }
  }

  /** Everything that a server sends to a robot, as somebody on the Wi-Fi hears it. */
  private byte[] recordOfARightConnection() throws Exception {
    try (ServerSocket between = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      CompletableFuture<byte[]> recorder =
          CompletableFuture.supplyAsync(() -> relay(between), Thread::startVirtualThread);
      CompletableFuture<LinkSocket> taken = accepted(LIMIT);
      Socket wire = new Socket(between.getInetAddress(), between.getLocalPort());
      try (LinkSocket made =
          server.connect(wire, LinkTls.LINK, (p, _) -> p.equals(robot.fingerprint()), LIMIT)) {
        made.out().write("drive".getBytes(StandardCharsets.US_ASCII));
        taken.join().in().readNBytes(5);
      }
      taken.join().close();
      return recorder.join();
    }
  }

  private byte[] relay(ServerSocket between) {
    try (Socket from = between.accept();
        Socket to = tcp()) {
      Thread.startVirtualThread(
          () -> {
            try {
              to.getInputStream().transferTo(from.getOutputStream());
            } catch (IOException e) {
              // both ends are closed in the end
            }
          });
      ByteArrayOutputStream heard = new ByteArrayOutputStream();
      InputStream in = from.getInputStream();
      byte[] part = new byte[4096];
      for (int n = in.read(part); n > 0; n = in.read(part)) {
        heard.write(part, 0, n);
        to.getOutputStream().write(part, 0, n);
      }
      return heard.toByteArray();
    } catch (IOException e) {
      throw new CompletionException(e);
    }
  }

  private Socket tcp() throws IOException {
    return new Socket(listener.getInetAddress(), listener.getLocalPort());
  }

  private LinkSocket connected(LinkTls who, Fingerprint pinned) throws IOException {
    return who.connect(tcp(), LinkTls.LINK, (peer, _) -> peer.equals(pinned), LIMIT);
  }

  /** The robot takes the next connection, if it is the server's. */
  private CompletableFuture<LinkSocket> accepted(Duration limit) {
    return accepted(listener::accept, limit);
  }

  private CompletableFuture<LinkSocket> accepted(Callable<Socket> next, Duration limit) {
    return CompletableFuture.supplyAsync(
        () -> {
          try {
            return robot.accept(next.call(), (peer, _) -> peer.equals(server.fingerprint()), limit);
          } catch (Exception e) {
            throw new CompletionException(e);
          }
        },
        Thread::startVirtualThread);
  }

  private static Reason failure(CompletableFuture<LinkSocket> taken) {
    CompletionException e = assertThrows(CompletionException.class, taken::join);
    return assertInstanceOf(HandshakeException.class, e.getCause()).reason();
  }

  /** A client that trusts everybody. */
  private SSLSocket socket(String version, @Nullable Identity identity)
      throws IOException, GeneralSecurityException {
    SSLContext context = SSLContext.getInstance("TLS");
    context.init(
        identity == null ? null : identity.keyManagers(),
        new TrustManager[] {new PinnedTrustManager((_, _) -> true)},
        null);
    SSLSocket socket =
        (SSLSocket)
            context
                .getSocketFactory()
                .createSocket(listener.getInetAddress(), listener.getLocalPort());
    socket.setEnabledProtocols(new String[] {version});
    return socket;
  }

  /** Pauses before each piece that it sends. */
  private static final class SlowSocket extends Socket {

    @Override
    public OutputStream getOutputStream() throws IOException {
      return new FilterOutputStream(super.getOutputStream()) {
        @Override
        public void write(byte[] bytes, int from, int length) throws IOException {
          try {
            Thread.sleep(50);
          } catch (InterruptedException e) {
            throw new IOException(e);
          }
          out.write(bytes, from, length);
        }
      };
    }
  }
}
