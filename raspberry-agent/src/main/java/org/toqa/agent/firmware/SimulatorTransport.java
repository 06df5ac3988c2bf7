package org.toqa.agent.firmware;

import java.io.EOFException;
import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * To the simulated microcontroller of {@code firmware/sim} over its Unix socket. Until the end of
 * each exchange the microcontroller is simulated for as long as the daemon ran since the last one,
 * or less.
 */
public final class SimulatorTransport implements FrameTransport {

  private static final Logger log = LoggerFactory.getLogger(SimulatorTransport.class);

  /**
   * The pause between exchanges that the microcontroller needs to answer in the next one, and an
   * exchange: 64 bytes of 256 cycles at 8 MHz.
   */
  private static final long MIN_MICROS = 5_000 + 2_048;

  /**
   * The microcontroller is simulated no longer at once, which is less than what makes it miss its
   * daemon: a machine that is too slow slows the simulated world and trips no timer of it.
   */
  private static final long MAX_MICROS = 100_000;

  private static final int HEADER = 7;

  private final SocketChannel channel;
  private boolean started;
  private long lastNanos;

  /** Micros until the microcontroller is as old as the daemon; below 0 it is ahead. */
  private long dueMicros;

  /**
   * Connects to the simulator.
   *
   * @param socket the Unix socket on which it listens
   * @throws IOException with a sentence for people: nothing listens there
   */
  public SimulatorTransport(Path socket) throws IOException {
    try {
      channel = SocketChannel.open(StandardProtocolFamily.UNIX);
    } catch (UnsupportedOperationException e) {
      throw new IOException("This system has no Unix sockets.", e);
    }
    try {
      channel.connect(UnixDomainSocketAddress.of(socket));
    } catch (IOException e) {
      channel.close();
      throw new IOException("No simulated microcontroller listens at " + socket + ".", e);
    }
  }

  @Override
  public byte[] exchange(byte[] frame, long nanos) throws IOException {
    dueMicros += started ? (nanos - lastNanos) / 1_000 : 0;
    started = true;
    lastNanos = nanos;
    long micros = Math.clamp(dueMicros, MIN_MICROS, MAX_MICROS);
    dueMicros = Math.min(0, dueMicros - micros);
    ByteBuffer request =
        ByteBuffer.allocate(HEADER + frame.length)
            .order(ByteOrder.LITTLE_ENDIAN)
            .put((byte) 'X')
            .putInt((int) micros)
            .putShort((short) frame.length)
            .put(frame)
            .flip();
    while (request.hasRemaining()) {
      channel.write(request);
    }
    return read(frame.length);
  }

  @Override
  public void expectLoad(double kilograms) {
    byte[] order =
        "Sbox %d\n".formatted(Math.round(1_000 * kilograms)).getBytes(StandardCharsets.US_ASCII);
    ByteBuffer request = ByteBuffer.wrap(order);
    try {
      while (request.hasRemaining()) {
        channel.write(request);
      }
      read("ok\n".length());
    } catch (IOException e) {
      log.warn("The simulated microcontroller takes no box: {}", e.getMessage());
    }
  }

  private byte[] read(int length) throws IOException {
    ByteBuffer answer = ByteBuffer.allocate(length);
    while (answer.hasRemaining()) {
      if (channel.read(answer) < 0) {
        throw new EOFException("The simulated microcontroller has ended.");
      }
    }
    return answer.array();
  }

  @Override
  public void close() {
    try {
      channel.close();
    } catch (IOException e) {
      // nothing of it is used any more
    }
  }
}
