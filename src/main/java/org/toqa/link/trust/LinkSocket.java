package org.toqa.link.trust;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.time.Duration;
import org.jspecify.annotations.Nullable;

/** One connection of the robot link, and who is at its other end. */
public final class LinkSocket implements AutoCloseable {

  private final Socket tcp;
  private final Socket stream;
  private final @Nullable Fingerprint peer;
  private final String protocol;

  /**
   * @param tcp carries the bytes
   * @param stream the same where they are not encrypted
   */
  LinkSocket(Socket tcp, Socket stream, @Nullable Fingerprint peer, String protocol) {
    this.tcp = tcp;
    this.stream = stream;
    this.peer = peer;
    this.protocol = protocol;
  }

  /** A connection that is not encrypted: nobody knows who is at its other end. */
  public static LinkSocket plain(Socket connected) {
    return new LinkSocket(connected, connected, null, "");
  }

  /**
   * The same as what another link is carried in: who is at the other end of that is not known yet.
   */
  public LinkSocket asCarrier() {
    return new LinkSocket(tcp, stream, null, "");
  }

  /** Who has proved to be at the other end; null where the link is not encrypted. */
  public @Nullable Fingerprint peer() {
    return peer;
  }

  /** Whether the other end wants to pair. */
  public boolean isForPairing() {
    return protocol.equals(LinkTls.PAIRING);
  }

  /**
   * @param silence the longest wait for a byte
   * @throws IOException when the socket is closed
   */
  public void setReadLimit(Duration silence) throws IOException {
    tcp.setSoTimeout((int) silence.toMillis());
  }

  /**
   * Tells the other end that nothing more comes; what it says can still be read.
   *
   * @throws IOException when the socket is closed
   */
  public void endOutput() throws IOException {
    stream.shutdownOutput();
  }

  Socket tcp() {
    return tcp;
  }

  Socket stream() {
    return stream;
  }

  public InetAddress remoteAddress() {
    return tcp.getInetAddress();
  }

  /**
   * What the other end sends, decrypted.
   *
   * @throws IOException when the socket is closed or not connected
   */
  public InputStream in() throws IOException {
    return stream.getInputStream();
  }

  /**
   * What is sent to the other end.
   *
   * @throws IOException when the socket is closed or not connected
   */
  public OutputStream out() throws IOException {
    return stream.getOutputStream();
  }

  /**
   * Closes the connection when the limit is over, unless the result is closed before.
   *
   * @param limit of real time, from now on
   */
  public TimeLimit startTimeLimit(Duration limit) {
    return new TimeLimit(tcp, limit);
  }

  /** Closes it at once: TLS's closing alert would wait for a peer that does not read. */
  @Override
  public void close() throws IOException {
    tcp.close();
  }
}
