package org.toqa.agent.connection;

import java.io.IOException;
import java.io.OutputStream;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.LinkSocket;

/**
 * One connection of a server. Its reading thread waits while the inbox is full, so that a peer that
 * talks too much is slowed down by TCP; its writing thread takes from a bounded queue, and a peer
 * that does not listen is dropped. {@link #send} and {@link #close} never wait.
 */
public final class PeerConnection implements AutoCloseable {

  private static final Logger log = LoggerFactory.getLogger(PeerConnection.class);

  /** About a minute of states. */
  private static final int QUEUED_LINES = 300;

  private final String robot;
  private final LinkSocket socket;
  private final Listener listener;
  private final BlockingQueue<byte[]> outbox = new ArrayBlockingQueue<>(QUEUED_LINES);
  private final Thread reader;
  private final Thread writer;
  private volatile @Nullable String endReason;

  /** Takes what is heard; may wait. */
  @FunctionalInterface
  public interface Listener {
    void handle(ConnectionEvent event) throws InterruptedException;
  }

  public PeerConnection(String robot, LinkSocket socket, Listener listener) {
    this.robot = robot;
    this.socket = socket;
    this.listener = listener;
    reader = Thread.ofVirtual().name(robot + "-reader").unstarted(this::readLines);
    writer = Thread.ofVirtual().name(robot + "-writer").unstarted(this::writeLines);
  }

  public void start() {
    reader.start();
    writer.start();
  }

  /** Who is at the other end; null where the link is not encrypted. */
  @Nullable
  public Fingerprint peer() {
    return socket.peer();
  }

  public void send(AgentMessage message) {
    if (!outbox.offer(LinkCodec.encode(message))) {
      log.warn("{}: the server does not take its lines; the connection is dropped.", robot);
      close();
    }
  }

  /** Why nothing more will be heard, a clause; null while the connection lives. */
  @Nullable
  public String endReason() {
    return endReason;
  }

  @Override
  public void close() {
    reader.interrupt();
    writer.interrupt();
    try {
      socket.close();
    } catch (IOException e) {
      log.debug("{}: closing the connection failed.", robot, e);
    }
  }

  private void readLines() {
    try {
      listener.handle(new ConnectionEvent.Opened(this));
      LineReader lines = new LineReader(socket.in());
      for (LineReader.Line line = lines.readLine(); line != null; line = lines.readLine()) {
        listener.handle(
            new ConnectionEvent.LineReceived(this, LinkCodec.decodeServerMessage(line)));
      }
      endReason = "the server closed it";
    } catch (IOException e) {
      endReason = String.valueOf(e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      endReason = "it was closed here";
    }
    close();
  }

  private void writeLines() {
    try {
      OutputStream out = socket.out();
      while (true) {
        out.write(outbox.take());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (IOException e) {
      log.debug("{}: writing ended.", robot, e);
    }
  }
}
