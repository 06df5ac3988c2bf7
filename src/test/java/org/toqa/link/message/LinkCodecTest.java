package org.toqa.link.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.toqa.geometry.Pose;
import org.toqa.motion.Segment;

class LinkCodecTest {

  @ParameterizedTest
  @MethodSource("serverLines")
  void serverLineReadsAndWritesAsItIs(String line) {
    assertEquals(
        line, text(LinkCodec.encode(understood(LinkCodec.decodeServerMessage(line(line))))));
  }

  @ParameterizedTest
  @MethodSource("agentLines")
  void agentLineReadsAndWritesAsItIs(String line) {
    assertEquals(
        line, text(LinkCodec.encode(understood(LinkCodec.decodeAgentMessage(line(line))))));
  }

  @Test
  void goldenLinesHaveEveryTypeOfMessage() {
    assertEquals(types(ServerMessage.class), typesIn(serverLines()));
    assertEquals(types(AgentMessage.class), typesIn(agentLines()));
  }

  @Test
  void fieldsOfALineReachTheirPlaces() {
    String drive = serverLines().findFirst().orElseThrow();

    assertEquals(
        new ServerMessage.Drive(
            7,
            42L,
            2,
            new Pose(1.5, 2.25, 0),
            List.of(new Segment(0.25, 0, 1.2), new Segment(0.25, 0.69, 1.138)),
            1,
            true,
            2.5),
        understood(LinkCodec.decodeServerMessage(line(drive))));
  }

  @Test
  void unknownFieldsAreIgnored() {
    assertEquals(
        new ServerMessage.Ping(3),
        understood(
            LinkCodec.decodeServerMessage(
                line("{\"type\":\"ping\",\"seq\":3,\"mood\":{\"x\":[1]}}"))));
  }

  /** As an earlier release sends it. */
  @Test
  void robotThatDoesNotTellItTurnsByThreeAndAHalf() {
    String hello = agentLines().findFirst().orElseThrow().replace(",\"maxTurnRate\":3.5", "");

    var said =
        assertInstanceOf(
            AgentMessage.Hello.class, understood(LinkCodec.decodeAgentMessage(line(hello))));
    assertEquals(3.5, said.maxTurnRate());
  }

  /** As an earlier release sends it. */
  @ParameterizedTest
  @MethodSource({"serverLines", "agentLines"})
  void whoDoesNotTellItGoesNotSideways(String line) {
    String earlier = line.replaceAll(",\"u\":[-0-9.]+", "").replaceAll(",\"shifts\":\\w+", "");
    String same =
        line.replaceAll("\"u\":[-0-9.]+", "\"u\":0.0")
            .replaceAll("\"shifts\":\\w+", "\"shifts\":false");
    assertEquals(
        same,
        serverLines().anyMatch(line::equals)
            ? text(LinkCodec.encode(understood(LinkCodec.decodeServerMessage(line(earlier)))))
            : text(LinkCodec.encode(understood(LinkCodec.decodeAgentMessage(line(earlier))))));
  }

  /** As an earlier release sends it. */
  @Test
  void robotThatDoesNotTellItHasNoRouteInAnAdHocNetwork() {
    String state =
        agentLines()
            .filter(line -> line.contains("networkRoute"))
            .map(line -> line.replaceAll("\"networkRoute\":\\{[^}]*},", ""))
            .findFirst()
            .orElseThrow();

    var said =
        assertInstanceOf(
            AgentMessage.State.class, understood(LinkCodec.decodeAgentMessage(line(state))));
    assertNull(said.networkRoute());
  }

  /** As an earlier release sends it. */
  @Test
  void faultThatDoesNotTellItIsNotClearable() {
    String state =
        agentLines()
            .filter(line -> line.contains("clearable"))
            .map(line -> line.replaceAll(",\"clearable\":(true|false)", ""))
            .findFirst()
            .orElseThrow();

    var said =
        assertInstanceOf(
            AgentMessage.State.class, understood(LinkCodec.decodeAgentMessage(line(state))));
    assertEquals(2, said.errors().size());
    assertTrue(said.errors().stream().noneMatch(AgentMessage.Fault::clearable));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          {"type":"dance","seq":4}                          | 4 | The type "dance" is not known; known are drive, extend,
          {"seq":4}                                         | 4 | The message has no type.
          {"type":7,"seq":4}                                | 4 | The message has no type.
          {"type":"hold"}                                   | 0 | The field "seq" of the hold is missing or of the wrong kind.
          {"type":"hold","seq":"4"}                         | 0 | The field "seq" of the hold is missing
          {"type":"hold","seq":4.5}                         | 0 | The field "seq" of the hold is missing
          {"type":"hold","seq":null}                        | 0 | The field "seq" of the hold is missing
          {"type":"hold","seq":1e400}                       | 0 | A number of the hold is not finite or absurdly large.
          {"type":"hold","seq":99999999999999999999}        | 0 | A number of the hold is not finite or absurdly large.
          {"type":"hold","seq":9007199254740994}            | 0 | A number of the hold is not finite or absurdly large.
          {"type":"hold","seq":4,"seq":5}                   | 0 | The line is not one JSON object in UTF-8.
          {"type":"hold","seq":4} {}                        | 0 | The line is not one JSON object in UTF-8.
          {"type":"hold","seq":4                            | 0 | The line is not one JSON object in UTF-8.
          [1,2]                                             | 0 | The line is not one JSON object in UTF-8.
          ``                                                | 0 | The line is not one JSON object in UTF-8.
          {"type":"release","seq":4,"drive":1,"released":true}       | 4 | The field "released" of the release is missing
          {"type":"release","seq":4,"drive":1,"released":1e12}       | 4 | The field "released" of the release is missing
          {"type":"locate","seq":4,"pose":null}                      | 4 | The field "pose" of the locate is missing
          {"type":"locate","seq":4,"pose":{"x":1,"y":2}}             | 4 | The field "pose.theta" of the locate is missing
          {"type":"locate","seq":4,"pose":{"x":1,"y":2,"theta":"NaN"}}| 4 | The field "pose.theta" of the locate is missing
          {"type":"locate","seq":4,"pose":{"x":1e300,"y":2,"theta":0}}| 4 | A number of the locate is not finite or absurdly large.
          {"type":"locate","seq":4,"pose":{"x":NaN,"y":2,"theta":0}}  | 0 | The line is not one JSON object in UTF-8.
          {"type":"extend","seq":4,"drive":1,"from":0,"segments":[{"v":1,"w":0,"t":"x"}],"released":0,"final":true} | 4 | The field "segments[0].t" of the extend is missing
          {"type":"follow","seq":4,"task":1,"leader":5.0,"fingerprint":null,"offset":{"x":1,"y":0},"tolerance":0.1} | 4 | The field "leader" of the follow is missing
          {"type":"extend","seq":4,"drive":1,"from":0,"segments":[null],"released":0,"final":true} | 4 | The field "segments
          """)
  void wrongLineIsRefusedWithASentence(String line, long seq, String start) {
    var refused =
        assertInstanceOf(
            DecodeResult.Invalid.class,
            LinkCodec.decodeServerMessage(line(Objects.requireNonNullElse(line, ""))));

    assertEquals(seq, refused.seq(), refused.reason());
    assertTrue(refused.reason().startsWith(start), refused.reason());
  }

  @Test
  void bytesThatAreNoUtf8AreRefused() {
    LineReader.Text line = line("{\"type\":\"hold\",\"seq\":4,\"x\":\"??\"}");
    line.utf8()[line.utf8().length - 3] = (byte) 0xff;

    assertInstanceOf(DecodeResult.Invalid.class, LinkCodec.decodeServerMessage(line));
  }

  @Test
  void deepNestingIsRefused() {
    assertInstanceOf(
        DecodeResult.Invalid.class,
        LinkCodec.decodeServerMessage(
            line("{\"type\":\"hold\",\"seq\":4,\"x\":" + "[".repeat(30_000))));
  }

  @Test
  void statedNumberOfSegmentsFitsIntoALine() {
    Segment longest = new Segment(-0.12345678901234567e-5, -0.12345678901234567e-5, 1.1e-100 / 3);
    var drive =
        new ServerMessage.Drive(
            Long.MAX_VALUE,
            Long.MAX_VALUE,
            3,
            new Pose(-1e4 / 3, -1e4 / 3, -1.0 / 3),
            Collections.nCopies(LinkCodec.SEGMENTS_A_LINE, longest),
            LinkCodec.SEGMENTS_A_LINE,
            false,
            0);

    assertTrue(LinkCodec.encode(drive).length <= LinkCodec.MAX_LINE_BYTES);
  }

  @Test
  void messageLongerThanALineIsNotWritten() {
    var drive =
        new ServerMessage.Drive(
            1,
            1L,
            1,
            new Pose(0, 0, 0),
            Collections.nCopies(5_000, new Segment(0.25, 0, 1)),
            0,
            true,
            0);

    assertThrows(IllegalArgumentException.class, () -> LinkCodec.encode(drive));
  }

  private static Stream<String> serverLines() {
    return golden("server.golden");
  }

  private static Stream<String> agentLines() {
    return golden("agent.golden");
  }

  private static Stream<String> golden(String name) {
    try (InputStream in = LinkCodecTest.class.getResourceAsStream(name)) {
      return new String(Objects.requireNonNull(in).readAllBytes(), StandardCharsets.UTF_8).lines();
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private static Set<String> types(Class<?> messages) {
    return Arrays.stream(messages.getAnnotation(JsonSubTypes.class).value())
        .map(JsonSubTypes.Type::name)
        .collect(Collectors.toSet());
  }

  private static Set<String> typesIn(Stream<String> lines) {
    return lines.map(line -> line.split("\"", -1)[3]).collect(Collectors.toSet());
  }

  private static <M> M understood(DecodeResult<M> reading) {
    return switch (reading) {
      case DecodeResult.Decoded<M>(M message) -> message;
      case DecodeResult.Invalid<M>(long seq, String reason) ->
          throw new AssertionError(seq + ": " + reason);
    };
  }

  private static LineReader.Text line(String text) {
    return new LineReader.Text(text.getBytes(StandardCharsets.UTF_8));
  }

  private static String text(byte[] line) {
    String text = new String(line, StandardCharsets.UTF_8);
    assertTrue(text.endsWith("\n"));
    return text.substring(0, text.length() - 1);
  }
}
