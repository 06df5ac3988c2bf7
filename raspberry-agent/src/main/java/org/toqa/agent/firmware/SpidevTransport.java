package org.toqa.agent.firmware;

import java.io.IOException;
import java.lang.foreign.Arena;
import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.Linker;
import java.lang.foreign.MemoryLayout;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.VarHandle;
import java.nio.file.Path;

/**
 * To a microcontroller on the SPI bus of a Raspberry Pi, by Linux's spidev. Mode 0, 8 bits, most
 * significant bit first.
 *
 * <p>Each byte is a transfer of its own, with a delay after it: the delay between the words of one
 * transfer, which spidev has too, is silently ignored by the controllers of a Raspberry Pi. A frame
 * goes by two messages, since spidev has room for 4,096 bytes in one, and rounds every transfer up
 * to as many as 128.
 */
public final class SpidevTransport implements FrameTransport {

  /** Of the request in {@code linux/spi/spidev.h}, struct spi_ioc_transfer. */
  private static final MemoryLayout TRANSFER =
      MemoryLayout.structLayout(
          ValueLayout.JAVA_LONG.withName("tx_buf"),
          ValueLayout.JAVA_LONG.withName("rx_buf"),
          ValueLayout.JAVA_INT.withName("len"),
          ValueLayout.JAVA_INT.withName("speed_hz"),
          ValueLayout.JAVA_SHORT.withName("delay_usecs"),
          ValueLayout.JAVA_BYTE.withName("bits_per_word"),
          ValueLayout.JAVA_BYTE.withName("cs_change"),
          ValueLayout.JAVA_BYTE.withName("tx_nbits"),
          ValueLayout.JAVA_BYTE.withName("rx_nbits"),
          ValueLayout.JAVA_BYTE.withName("word_delay_usecs"),
          ValueLayout.JAVA_BYTE.withName("pad"));

  private static final long SPI_IOC_WR_MODE = 0x40016b01L;

  /** Of 32 transfers, 1,024 bytes. */
  private static final long SPI_IOC_MESSAGE_32 = 0x44006b00L;

  private static final int TRANSFERS = 32;
  private static final int O_RDWR = 2;
  private static final byte BITS = 8;

  /** At the end of a message: until the next one. */
  private static final byte STAYS_SELECTED = 1;

  private static final Linker LINKER = Linker.nativeLinker();
  private static final Linker.Option ERRNO = Linker.Option.captureCallState("errno");
  private static final MemoryLayout CALL_STATE = Linker.Option.captureStateLayout();
  private static final VarHandle ERRNO_OF_CALL =
      CALL_STATE.varHandle(MemoryLayout.PathElement.groupElement("errno"));

  /** Open and ioctl are variadic in C. */
  private static final Linker.Option AFTER_TWO = Linker.Option.firstVariadicArg(2);

  private static final MethodHandle OPEN =
      function(
          "open",
          FunctionDescriptor.of(ValueLayout.JAVA_INT, ValueLayout.ADDRESS, ValueLayout.JAVA_INT),
          ERRNO,
          AFTER_TWO);
  private static final MethodHandle IOCTL =
      function(
          "ioctl",
          FunctionDescriptor.of(
              ValueLayout.JAVA_INT,
              ValueLayout.JAVA_INT,
              ValueLayout.JAVA_LONG,
              ValueLayout.ADDRESS),
          ERRNO,
          AFTER_TWO);
  private static final MethodHandle CLOSE =
      function("close", FunctionDescriptor.of(ValueLayout.JAVA_INT, ValueLayout.JAVA_INT), ERRNO);

  private final Arena arena = Arena.ofConfined();
  private final MemorySegment callState = arena.allocate(CALL_STATE);
  private final MemorySegment sent = arena.allocate(FrameCodec.LENGTH);
  private final MemorySegment received = arena.allocate(FrameCodec.LENGTH);
  private final MemorySegment transfers = arena.allocate(TRANSFER, FrameCodec.LENGTH);
  private final Path device;
  private final int file;

  /**
   * @param device such as {@code /dev/spidev0.0}
   * @param hertz of the bus's clock
   * @param wordDelayMicros pause after each byte, microseconds
   * @throws IOException with a sentence for people: it cannot be opened or is no SPI device
   */
  public SpidevTransport(Path device, int hertz, int wordDelayMicros) throws IOException {
    this.device = device;
    for (int i = 0; i < FrameCodec.LENGTH; i++) {
      set(i, "tx_buf", sent.address() + i);
      set(i, "rx_buf", received.address() + i);
      set(i, "len", 1);
      set(i, "speed_hz", hertz);
      set(i, "bits_per_word", BITS);
      set(i, "delay_usecs", (short) wordDelayMicros);
    }
    set(TRANSFERS - 1, "cs_change", STAYS_SELECTED);
    file = call(OPEN, callState, arena.allocateFrom(device.toString()), O_RDWR);
    if (file < 0) {
      IOException failure =
          failure("cannot be opened; check that SPI is switched on and that this user may use it");
      arena.close();
      throw failure;
    }
    MemorySegment mode0 = arena.allocate(ValueLayout.JAVA_BYTE);
    if (call(IOCTL, callState, file, SPI_IOC_WR_MODE, mode0) < 0) {
      IOException failure = failure("is no SPI device");
      close();
      throw failure;
    }
  }

  @Override
  public byte[] exchange(byte[] frame, long nanos) throws IOException {
    sent.copyFrom(MemorySegment.ofArray(frame));
    for (int first = 0; first < FrameCodec.LENGTH; first += TRANSFERS) {
      MemorySegment message = transfers.asSlice(first * TRANSFER.byteSize());
      if (call(IOCTL, callState, file, SPI_IOC_MESSAGE_32, message) < 0) {
        throw failure("exchanged nothing");
      }
    }
    return received.toArray(ValueLayout.JAVA_BYTE);
  }

  @Override
  public void close() {
    call(CLOSE, callState, file);
    arena.close();
  }

  private void set(int index, String field, Object value) {
    TRANSFER
        .varHandle(MemoryLayout.PathElement.groupElement(field))
        .set(transfers, index * TRANSFER.byteSize(), value);
  }

  private IOException failure(String what) {
    return new IOException(
        "%s %s (errno %d).".formatted(device, what, (int) ERRNO_OF_CALL.get(callState, 0L)));
  }

  @SuppressWarnings("restricted") // the manifest allows native access
  private static MethodHandle function(
      String name, FunctionDescriptor type, Linker.Option... options) {
    return LINKER
        .defaultLookup()
        .find(name)
        .map(symbol -> LINKER.downcallHandle(symbol, type, options))
        .orElseThrow(() -> new UnsatisfiedLinkError("This system has no function " + name + "."));
  }

  private static int call(MethodHandle function, Object... arguments) {
    try {
      return (int) function.invokeWithArguments(arguments);
    } catch (RuntimeException | Error e) {
      throw e;
    } catch (Throwable e) {
      throw new IllegalStateException(e);
    }
  }
}
