package org.toqa.link.channel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Objects;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.link.channel.LineChannel.WhenFull;
import org.toqa.link.message.LineReader;
import org.toqa.link.trust.LinkSocket;

/** A channel over loopback, whose other end the test plays by hand. */
@Timeout(30)
class LineChannelTest {

  private Socket own;
  private Socket peer;

  @BeforeEach
  void connect() throws IOException {
    try (ServerSocket listener = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      own = new Socket(listener.getInetAddress(), listener.getLocalPort());
      peer = listener.accept();
    }
  }

  @AfterEach
  void close() throws IOException {
    own.close();
    peer.close();
  }

  @Test
  void linesGoBothWaysInTheirOrder() throws Exception {
    try (LineChannel channel = channel(10, WhenFull.CLOSE)) {
      channel.start();
      assertTrue(channel.send(bytes("one\n")));
      assertTrue(channel.send(bytes("two\n")));
      LineReader lines = new LineReader(peer.getInputStream());
      assertEquals("one", text(Objects.requireNonNull(lines.readLine())));
      assertEquals("two", text(Objects.requireNonNull(lines.readLine())));

      peer.getOutputStream().write(bytes("three\nfour\n"));
      assertEquals("three", text(Objects.requireNonNull(channel.readLine())));
      assertEquals("four", text(Objects.requireNonNull(channel.readLine())));
      peer.close();
      assertNull(channel.readLine());
    }
  }

  @Test
  void fullChannelThatMayMissNoLineIsClosed() throws Exception {
    LineChannel channel = channel(2, WhenFull.CLOSE);
    assertTrue(channel.send(bytes("one\n")));
    assertTrue(channel.send(bytes("two\n")));
    assertFalse(channel.hasOverflowed());

    assertFalse(channel.send(bytes("three\n")));
    assertTrue(channel.hasOverflowed());
    assertEquals(-1, peer.getInputStream().read());
  }

  @Test
  void fullChannelMayDropTheOldestLines() throws Exception {
    try (LineChannel channel = channel(2, WhenFull.DROP_OLDEST)) {
      for (String line : new String[] {"one\n", "two\n", "three\n"}) {
        assertTrue(channel.send(bytes(line)));
      }
      assertFalse(channel.hasOverflowed());

      channel.start();
      LineReader lines = new LineReader(peer.getInputStream());
      assertEquals("two", text(Objects.requireNonNull(lines.readLine())));
      assertEquals("three", text(Objects.requireNonNull(lines.readLine())));
    }
  }

  @Test
  void closedChannelReadsNothingMore() throws Exception {
    LineChannel channel = channel(2, WhenFull.CLOSE);
    channel.start();
    channel.close();
    channel.close();
    assertThrows(IOException.class, () -> channel.readLine());
    assertEquals(-1, peer.getInputStream().read());
  }

  private LineChannel channel(int capacity, WhenFull whenFull) {
    return new LineChannel(LinkSocket.plain(own), "test", capacity, whenFull);
  }

  private static byte[] bytes(String line) {
    return line.getBytes(StandardCharsets.UTF_8);
  }

  private static String text(LineReader.Line line) {
    return new String(assertInstanceOf(LineReader.Text.class, line).utf8(), StandardCharsets.UTF_8);
  }
}
