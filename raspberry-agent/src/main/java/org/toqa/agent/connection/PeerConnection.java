package org.toqa.agent.connection;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicLong;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.channel.LineChannel;
import org.toqa.link.channel.LineChannel.WhenFull;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.LinkSocket;

/**
 * One connection of a server or a leader. Its reading thread waits while the inbox is full, so that
 * a peer that sends too much is slowed down by TCP; a peer that does not read is dropped. {@link
 * #send} and {@link #close} never wait.
 */
public final class PeerConnection implements AutoCloseable {

  private static final Logger log = LoggerFactory.getLogger(PeerConnection.class);

  /** About a minute of states. */
  private static final int QUEUED_LINES = 300;

  private final String robot;
  private final InetAddress remoteAddress;
  private final LineChannel channel;
  private final Listener listener;
  private static final Pattern HTTP_REQUEST = Pattern.compile("[A-Z]+ \\S+ HTTP/");

  private final Thread reader;
  private volatile @Nullable String endReason;

  /** Counted by the reading thread. */
  private final AtomicLong received = new AtomicLong();

  private long sent;

  /** Takes what is received; may wait. */
  @FunctionalInterface
  public interface Listener {
    void handle(ConnectionEvent event) throws InterruptedException;
  }

  public PeerConnection(String robot, LinkSocket socket, Listener listener) {
    this.robot = robot;
    remoteAddress = socket.remoteAddress();
    channel = new LineChannel(socket, robot, QUEUED_LINES, WhenFull.CLOSE);
    this.listener = listener;
    reader = Thread.ofVirtual().name(robot + "-reader").unstarted(this::readLines);
  }

  public void start() {
    reader.start();
    channel.start();
  }

  /** Who is at the other end; null where the link is not encrypted. */
  @Nullable
  public Fingerprint peer() {
    return channel.peer();
  }

  /** Whence it was made. */
  InetAddress remoteAddress() {
    return remoteAddress;
  }

  /** How many messages have come and were handed on. */
  long received() {
    return received.get();
  }

  /** How many messages it was given to send. */
  long sent() {
    return sent;
  }

  public void send(AgentMessage message) {
    sent++;
    if (!channel.send(LinkCodec.encode(message))) {
      log.warn("{}: the server does not take its lines; the connection is dropped.", robot);
      close();
    }
  }

  /** Why nothing more will be received, a clause; null while the connection is open. */
  @Nullable
  public String endReason() {
    return endReason;
  }

  @Override
  public void close() {
    reader.interrupt();
    channel.close();
  }

  private static boolean isHttpRequest(LineReader.Line line) {
    return line instanceof LineReader.Text(byte[] utf8)
        && HTTP_REQUEST.matcher(new String(utf8, StandardCharsets.ISO_8859_1)).lookingAt();
  }

  private void readLines() {
    try {
      listener.handle(new ConnectionEvent.Opened(this));
      for (LineReader.Line line = channel.readLine(); line != null; line = channel.readLine()) {
        if (isHttpRequest(line)) { // by a web page, whose body could be a message
          endReason = "it speaks HTTP";
          break;
        }
        listener.handle(
            new ConnectionEvent.LineReceived(this, LinkCodec.decodeServerMessage(line)));
        received.incrementAndGet();
      }
      endReason = Objects.requireNonNullElse(endReason, "the server closed it");
    } catch (IOException e) {
      endReason = String.valueOf(e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      endReason = "it was closed here";
    } finally { // else nobody would know that nothing comes any more
      endReason = Objects.requireNonNullElse(endReason, "reading it failed");
      close();
    }
  }
}
