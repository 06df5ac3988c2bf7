package org.toqa.agent.firmware;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.util.Arrays;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.toqa.agent.firmware.FirmwareCommand.Caption;

class FrameScannerPropertyTest {

  private final byte[] frame = FrameCodec.encode(new Caption("r1 10.0.0.1"), 7);

  @Property
  void frameIsFoundBehindWhateverCameBefore(
      @ForAll @Size(max = 150) byte[] before,
      @ForAll @IntRange(min = 0, max = FrameCodec.LENGTH - 1) int half) {
    FrameScanner scanner = new FrameScanner();
    add(scanner, before);
    add(scanner, Arrays.copyOf(frame, half));
    add(scanner, frame);

    assertArrayEquals(frame, scanner.takeFrame().orElseThrow());
    assertTrue(scanner.takeFrame().isEmpty());
  }

  @Property
  void frameIsFoundHoweverItsBytesArrive(
      @ForAll @Size(max = 20) List<@IntRange(min = 1, max = 9) Integer> pieces) {
    FrameScanner scanner = new FrameScanner();
    int sent = 0;
    for (int piece : pieces) {
      int end = Math.min(FrameCodec.LENGTH - 1, sent + piece);
      add(scanner, Arrays.copyOfRange(frame, sent, end));
      assertTrue(scanner.takeFrame().isEmpty());
      sent = end;
    }
    add(scanner, Arrays.copyOfRange(frame, sent, FrameCodec.LENGTH));

    assertArrayEquals(frame, scanner.takeFrame().orElseThrow());
  }

  @Property
  void lostByteCostsItsOwnFrameOnly(
      @ForAll @IntRange(min = 0, max = FrameCodec.LENGTH - 1) int lost) {
    FrameScanner scanner = new FrameScanner();
    ByteArrayOutputStream stream = new ByteArrayOutputStream();
    stream.write(frame, 0, lost);
    stream.write(frame, lost + 1, FrameCodec.LENGTH - lost - 1);
    stream.writeBytes(frame);
    add(scanner, stream.toByteArray());

    assertArrayEquals(frame, scanner.takeFrame().orElseThrow());
    assertTrue(scanner.takeFrame().isEmpty());
  }

  @Property
  void onlyTheNewestOfAFloodIsKept(@ForAll @Size(max = 1_000) byte[] flood) {
    FrameScanner scanner = new FrameScanner();
    add(scanner, frame);
    add(scanner, new byte[5 * FrameCodec.LENGTH]);
    add(scanner, flood);
    add(scanner, frame);

    assertArrayEquals(frame, scanner.takeFrame().orElseThrow());
    assertTrue(scanner.takeFrame().isEmpty());
  }

  private static void add(FrameScanner scanner, byte[] bytes) {
    scanner.add(bytes, bytes.length);
  }
}
