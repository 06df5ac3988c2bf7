package org.toqa.link.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import org.toqa.geometry.Pose;
import org.toqa.motion.Segment;

class LinkCodecProperties {

  @Property
  void anyBytesBecomeAMessageOrASentence(@ForAll byte[] bytes) {
    assertAnswered(bytes);
  }

  @Property
  void damagedDriveBecomesAMessageOrASentence(
      @ForAll("drives") ServerMessage.Drive drive,
      @ForAll @IntRange(max = 10_000) int place,
      @ForAll byte damage) {
    byte[] line = withoutLineFeed(LinkCodec.encode(drive));
    line[place % line.length] = damage;

    assertAnswered(line);
  }

  @Example
  void messageInAListIsNone() {
    assertAnswered("[\"ping\",{\"seq\":1}]".getBytes(StandardCharsets.UTF_8));
  }

  @Property
  void driveCutAnywhereIsRefused(
      @ForAll("drives") ServerMessage.Drive drive, @ForAll @IntRange(max = 10_000) int place) {
    byte[] line = withoutLineFeed(LinkCodec.encode(drive));

    assertTrue(
        LinkCodec.decodeServerMessage(new LineReader.Text(Arrays.copyOf(line, place % line.length)))
            instanceof DecodeResult.Invalid);
  }

  @Property
  void driveIsReadAsItWasWritten(@ForAll("drives") ServerMessage.Drive drive) {
    assertEquals(
        new DecodeResult.Decoded<ServerMessage>(drive),
        LinkCodec.decodeServerMessage(
            new LineReader.Text(withoutLineFeed(LinkCodec.encode(drive)))));
  }

  @Property
  void jsonWithFieldsOfAnyKindBecomesAMessageOrASentence(
      @ForAll("types") String type, @ForAll("values") List<String> values) {
    List<String> fields =
        List.of(
            "seq",
            "task",
            "phase",
            "start",
            "segments",
            "released",
            "final",
            "drive",
            "from",
            "pose",
            "done",
            "tolerance",
            "followers",
            "leader",
            "fingerprint",
            "offset");
    StringBuilder json = new StringBuilder("{\"type\":\"" + type + "\"");
    for (int i = 0; i < values.size(); i++) {
      json.append(",\"").append(fields.get(i)).append("\":").append(values.get(i));
    }

    assertAnswered((json + "}").getBytes(StandardCharsets.UTF_8));
  }

  @Provide
  Arbitrary<ServerMessage.Drive> drives() {
    Arbitrary<Double> numbers = Arbitraries.doubles().between(-1000, 1000);
    Arbitrary<Segment> segments =
        Combinators.combine(numbers, numbers, numbers, numbers)
            .as((v, w, t, u) -> new Segment(v, w, t, u));
    Arbitrary<Pose> poses =
        Combinators.combine(numbers, numbers, Arbitraries.doubles().between(-3, 3))
            .as((x, y, theta) -> new Pose(x, y, theta));
    return Combinators.combine(
            Arbitraries.longs().between(0, 1L << 49),
            Arbitraries.longs().between(0, 1L << 49).injectNull(0.2),
            Arbitraries.integers(),
            poses,
            segments.list().ofMaxSize(20),
            Arbitraries.integers(),
            Arbitraries.of(true, false))
        .as(
            (seq, task, phase, start, path, released, last) ->
                new ServerMessage.Drive(seq, task, phase, start, path, released, last, 0));
  }

  @Provide
  Arbitrary<String> types() {
    return Arbitraries.of(
        "drive", "extend", "release", "lead", "follow", "hold", "cancel", "locate", "ping", "ack");
  }

  @Provide
  Arbitrary<List<String>> values() {
    return Arbitraries.of(
            "1",
            "-1",
            "0.5",
            "1e308",
            "null",
            "true",
            "\"x\"",
            "\"Infinity\"",
            "[]",
            "{}",
            "[null]",
            "[{\"v\":0.1,\"w\":0,\"t\":1}]",
            "{\"x\":1,\"y\":1,\"theta\":1}")
        .list()
        .ofMaxSize(16);
  }

  /** And the same whether it is read at once or with care. */
  private static void assertAnswered(byte[] line) {
    assertEquals(
        LinkCodec.decodeAsTree(line, ServerMessage.class),
        LinkCodec.decodeServerMessage(new LineReader.Text(line)));
    assertEquals(
        LinkCodec.decodeAsTree(line, AgentMessage.class),
        LinkCodec.decodeAgentMessage(new LineReader.Text(line)));
    for (DecodeResult<?> reading :
        Stream.of(
                LinkCodec.decodeServerMessage(new LineReader.Text(line)),
                LinkCodec.decodeAgentMessage(new LineReader.Text(line)))
            .toList()) {
      if (reading instanceof DecodeResult.Invalid<?>(long _, String reason)) {
        assertFalse(reason.isBlank());
        assertTrue(reason.endsWith(".") && reason.length() < 300, reason);
      }
    }
  }

  private static byte[] withoutLineFeed(byte[] line) {
    return Arrays.copyOf(line, line.length - 1);
  }
}
