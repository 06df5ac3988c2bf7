package org.toqa.agent.firmware;

import com.fazecast.jSerialComm.SerialPort;
import com.fazecast.jSerialComm.SerialPortInvalidPortException;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/**
 * To a microcontroller on a serial port, such as the robot's RS-232: 8 bits, no parity, 1 stop bit,
 * no flow control. Nothing clocks the answer here, so it is waited for, as long as both frames need
 * on the wire and a little more. What came later than that is passed over, and a port that failed,
 * as when its cable was pulled, is opened anew.
 */
public final class SerialTransport implements FrameTransport {

  private static final int DATA_BITS = 8;

  /** With its start bit and its stop bit. */
  private static final int BITS_A_BYTE = 10;

  private static final long SECOND_NANOS = 1_000_000_000;

  /** For the microcontroller to answer, and for the kernel on this side. */
  private static final long ANSWER_TIMEOUT_NANOS = Duration.ofMillis(4).toNanos();

  private static final long POLL_INTERVAL_NANOS = Duration.ofNanos(500_000).toNanos();
  private static final long REOPEN_INTERVAL_NANOS = Duration.ofMillis(500).toNanos();

  private final Path device;
  private final int baud;
  private final long wireNanos;
  private final byte[] received = new byte[2 * FrameCodec.LENGTH];
  private final FrameScanner scanner = new FrameScanner();
  private @Nullable SerialPort port;
  private long openingNanos;

  /**
   * Opens the port.
   *
   * @param device such as {@code /dev/ttyUSB0}; a link is followed anew at each opening
   * @param baud bits a second
   * @throws IOException with a sentence for people
   */
  public SerialTransport(Path device, int baud) throws IOException {
    this.device = device;
    this.baud = baud;
    wireNanos = 2L * FrameCodec.LENGTH * BITS_A_BYTE * SECOND_NANOS / baud;
    try {
      port = open();
    } catch (LinkageError e) {
      throw new IOException(
          "%s cannot be opened: the library for serial ports does not run here (%s)."
              .formatted(device, e.getMessage()),
          e);
    }
  }

  @Override
  public byte[] exchange(byte[] frame, long nanos) throws IOException {
    SerialPort open = port == null ? reopen(nanos) : port;
    try {
      discardOldAnswers(open);
      send(open, frame);
      return awaitAnswer(open);
    } catch (IOException e) {
      close();
      openingNanos = nanos;
      throw e;
    }
  }

  @Override
  public void close() {
    if (port != null) {
      port.closePort();
      port = null;
    }
  }

  private SerialPort reopen(long nanos) throws IOException {
    if (nanos - openingNanos < REOPEN_INTERVAL_NANOS) {
      throw new IOException(device + " is not open.");
    }
    openingNanos = nanos;
    SerialPort opened = open();
    port = opened;
    return opened;
  }

  private SerialPort open() throws IOException {
    try {
      SerialPort fresh = SerialPort.getCommPort(device.toString());
      fresh.setComPortParameters(baud, DATA_BITS, SerialPort.ONE_STOP_BIT, SerialPort.NO_PARITY);
      fresh.setComPortTimeouts(SerialPort.TIMEOUT_NONBLOCKING, 0, 0);
      if (fresh.openPort()) {
        return fresh;
      }
      throw new IOException(
          "%s cannot be opened; check that it is plugged in and that this user may use it (errno %d)."
              .formatted(device, fresh.getLastErrorCode()));
    } catch (SerialPortInvalidPortException e) {
      throw new IOException("There is no serial port " + device + ".", e);
    }
  }

  private void discardOldAnswers(SerialPort open) throws IOException {
    scanner.clear();
    while (read(open) > 0) {
      // it answers an earlier frame
    }
  }

  private void send(SerialPort open, byte[] frame) throws IOException {
    if (open.writeBytes(frame, frame.length) != frame.length) {
      throw new IOException(device + " takes no frame.");
    }
  }

  /** Empty where no good frame came in time. */
  private byte[] awaitAnswer(SerialPort open) throws IOException {
    long sent = System.nanoTime();
    LockSupport.parkNanos(wireNanos);
    while (true) {
      scanner.add(received, read(open));
      Optional<byte[]> answer = scanner.takeFrame();
      if (answer.isPresent()) {
        return answer.get();
      }
      if (System.nanoTime() - sent > wireNanos + ANSWER_TIMEOUT_NANOS) {
        return new byte[0];
      }
      LockSupport.parkNanos(POLL_INTERVAL_NANOS);
    }
  }

  private int read(SerialPort open) throws IOException {
    int count = open.readBytes(received, received.length);
    if (count < 0) {
      throw new IOException(device + " is gone.");
    }
    return count;
  }
}
