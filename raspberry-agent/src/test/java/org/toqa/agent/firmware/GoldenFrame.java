package org.toqa.agent.firmware;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** A line of the golden frames, which the firmware's own tests read too: what it says, and it. */
record GoldenFrame(String kind, Map<String, String> values, byte[] frame) {

  private static final int SETTINGS = 6;
  private static final Path FILE = Path.of("firmware/test/golden-frames.txt");

  static Stream<GoldenFrame> all() throws IOException {
    return Files.readAllLines(FILE).stream()
        .filter(line -> line.contains("|") && !line.startsWith("#"))
        .map(GoldenFrame::parse);
  }

  /** The frames of one kind, in the order of the file. */
  static List<byte[]> of(String kind) throws IOException {
    return all().filter(golden -> golden.kind().equals(kind)).map(GoldenFrame::frame).toList();
  }

  /**
   * What a microcontroller that reports this status answers: it takes the settings, and it is at
   * rest.
   */
  static byte[] answer(byte[] status, byte[] command) {
    byte[] answer = status.clone();
    if (command[2] == SETTINGS && answer.length == FrameCodec.LENGTH) {
      answer[3] = command[3];
      answer[4] = 1; // done
    }
    return answer.length == FrameCodec.LENGTH ? atRest(answer) : answer;
  }

  /** The same status of a body at rest. */
  static byte[] atRest(byte[] status) {
    byte[] changed = status.clone();
    changed[5] = (byte) Math.min(changed[5], 1);
    ByteBuffer.wrap(changed)
        .order(ByteOrder.LITTLE_ENDIAN)
        .putShort(62, (short) Crc16.of(changed, 62));
    return changed;
  }

  private static GoldenFrame parse(String line) {
    int bar = line.indexOf(" | ");
    List<String> words = List.of(line.substring(0, bar).split(" ", -1));
    return new GoldenFrame(
        words.getFirst(),
        words.stream()
            .skip(1)
            .map(word -> word.split("=", 2))
            .collect(Collectors.toMap(pair -> pair[0], pair -> pair[1])),
        HexFormat.of().parseHex(line.substring(bar + 3)));
  }

  String text(String key) {
    return Objects.requireNonNull(values.get(key), key);
  }

  long number(String key) {
    return Long.parseLong(text(key));
  }

  double millionths(String key) {
    return number(key) / 1e6;
  }

  @Override
  public String toString() {
    return kind + " " + values;
  }
}
