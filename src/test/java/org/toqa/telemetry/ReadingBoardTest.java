package org.toqa.telemetry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.wording.Phrase;

/** What is believed of what robots publish. */
class ReadingBoardTest {
  private static final Instant NOW = Instant.parse("2026-11-21T08:00:00Z");
  private static final Topics TOPICS = new Topics("main");

  private final Set<String> robots = new HashSet<>(Set.of("r1", "r2"));
  private final List<String> told = new ArrayList<>();
  private final ReadingBoard board =
      new ReadingBoard(
          robots::contains, (robot, seen) -> told.add(robot + seen.values() + seen.angles()));

  private void receive(String topic, String body, Instant at) {
    board.receive(
        TOPICS.origin("toqa/v1/main/robot/" + topic),
        body.getBytes(StandardCharsets.UTF_8),
        false,
        at);
  }

  private Map<Refusal, Long> refusals() {
    return board.of("r1").refusals();
  }

  @Test
  void rangesAndValuesAreKeptWithTheTimeAtWhichTheyWereHeard() {
    receive("r1/range", "{\"stamp\":5,\"metres\":[0.5,30],\"more\":{}}", NOW);
    receive("r1/temperature", "{\"stamp\":6,\"value\":-3.5,\"unit\":\"°C\"}", NOW.plusSeconds(1));
    assertEquals(
        List.of(
            new Reading("range", 5, NOW, List.of(0.5, 30.0), "m", List.of()),
            new Reading("temperature", 6, NOW.plusSeconds(1), List.of(-3.5), "°C", List.of())),
        board.of("r1").readings());
    assertEquals(Map.of(), refusals());
    assertEquals(List.of(), board.of("r2").readings());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "range | nonsense | UNREADABLE",
        "range | [1] | UNREADABLE",
        "range | {\"stamp\":1,\"metres\":[1]} {} | UNREADABLE",
        "range | {\"stamp\":1,\"stamp\":2,\"metres\":[1]} | UNREADABLE",
        "range | {\"stamp\":1,\"metres\":[NaN]} | UNREADABLE",
        "range | {\"metres\":[1]} | WRONG_FIELD",
        "range | {\"stamp\":-1,\"metres\":[1]} | WRONG_FIELD",
        "range | {\"stamp\":1.5,\"metres\":[1]} | WRONG_FIELD",
        "range | {\"stamp\":1,\"metres\":[]} | WRONG_FIELD",
        "range | {\"stamp\":1,\"metres\":\"1\"} | WRONG_FIELD",
        "range | {\"stamp\":1,\"metres\":[1,null]} | WRONG_FIELD",
        "range | {\"stamp\":1,\"metres\":[1,-0.1]} | OUT_OF_BOUNDS",
        "range | {\"stamp\":1,\"metres\":[1],\"angles\":[0,1]} | WRONG_FIELD",
        "range | {\"stamp\":1,\"metres\":[1],\"angles\":7} | WRONG_FIELD",
        "range | {\"stamp\":1,\"metres\":[1],\"angles\":[7]} | OUT_OF_BOUNDS",
        "range | {\"stamp\":1,\"metres\":[30.1]} | OUT_OF_BOUNDS",
        "range | {\"stamp\":1,\"metres\":[1e999]} | OUT_OF_BOUNDS",
        "heat | {\"stamp\":1,\"value\":\"5\"} | WRONG_FIELD",
        "heat | {\"stamp\":1,\"value\":5,\"unit\":7} | WRONG_FIELD",
        "heat | {\"stamp\":1,\"value\":1e999} | OUT_OF_BOUNDS",
        "connection | perhaps | UNREADABLE",
      })
  void whatNoSensorSaysIsCountedAndNotKept(String reading, String body, Refusal why) {
    receive("r1/" + reading, body, NOW);
    assertEquals(Map.of(why, 1L), refusals());
    assertEquals(List.of(), board.of("r1").readings());
  }

  @Test
  void rangesWithTheirAnglesAreTold() {
    receive("r1/range", "{\"stamp\":1,\"metres\":[1]}", NOW);
    receive("r1/range", "{\"stamp\":1,\"metres\":[1,2],\"angles\":[-0.5,0.5]}", NOW);
    receive("r1/range", "{\"stamp\":1,\"metres\":[1,2],\"angles\":[-0.5]}", NOW);
    assertEquals(List.of("r1[1.0, 2.0][-0.5, 0.5]"), told);
  }

  @Test
  void largeBodyIsNotRead() {
    receive("r1/range", " ".repeat(4097), NOW);
    assertEquals(Map.of(Refusal.TOO_LARGE, 1L), refusals());
  }

  @Property
  void anyBytesAreTakenInOrCounted(@ForAll byte[] body) {
    ReadingBoard own = new ReadingBoard(name -> true, (robot, seen) -> {});
    own.receive(TOPICS.origin("toqa/v1/main/robot/r1/range"), body, false, NOW);
    long refused = own.of("r1").refusals().values().stream().mapToLong(Long::longValue).sum();
    assertEquals(1, refused + own.of("r1").readings().size());
  }

  @Test
  void whatTheBrokerHadKeptIsOfUnknownAge() {
    board.receive(
        TOPICS.origin("toqa/v1/main/robot/r1/range"),
        "{\"stamp\":1,\"metres\":[1]}".getBytes(StandardCharsets.UTF_8),
        true,
        NOW);
    assertEquals(Map.of(Refusal.RETAINED, 1L), refusals());
  }

  @Test
  void messagesOfNoRobotAreOnlyCounted() {
    receive("r9/range", "{\"stamp\":1,\"metres\":[1]}", NOW);
    receive("r1/RANGE", "{\"stamp\":1,\"metres\":[1]}", NOW);
    receive("r1/state", "{\"stamp\":1,\"metres\":[1]}", NOW);
    assertEquals(3, board.strangers());
    assertEquals(ReadingBoard.RobotReadings.NONE, board.of("r9"));
  }

  @Test
  void newestWinsWhereReadingsComeTooFast() {
    for (int i = 0; i < 1000; i++) {
      receive("r1/range", "{\"stamp\":%d,\"metres\":[1]}".formatted(i), NOW);
    }
    receive("r2/range", "{\"stamp\":7,\"metres\":[1]}", NOW);
    assertEquals(39, board.of("r1").readings().getFirst().stamp(), "40 at once");
    assertEquals(7, board.of("r2").readings().getFirst().stamp(), "another one's are not counted");
    board.update(NOW.plusSeconds(1));
    assertEquals(999, board.of("r1").readings().getFirst().stamp());
    assertEquals(NOW, board.of("r1").readings().getFirst().receivedAt());
    assertEquals(Map.of(Refusal.TOO_OFTEN, 959L), refusals()); // 1000 - 40 - the newest
  }

  /** The robot is elsewhere by then. */
  @Test
  void rangesThatHadToWaitAreNotTold() {
    for (int i = 0; i < 41; i++) {
      receive("r1/range", "{\"stamp\":1,\"metres\":[%d],\"angles\":[0]}".formatted(i % 30), NOW);
    }
    board.update(NOW.plusMillis(700));
    assertEquals(40, told.size());
  }

  @Test
  void robotHasSoManyKindsOfReadings() {
    for (int i = 0; i < 40; i++) {
      receive("r1/kind" + i, "{\"stamp\":1,\"value\":1}", NOW.plusSeconds(i));
    }
    assertEquals(ReadingBoard.MAX_READINGS, board.of("r1").readings().size());
    assertEquals(Map.of(Refusal.TOO_MANY_READINGS, 8L), refusals());
  }

  @Test
  void namesWithoutAReadingAreForgotten() {
    for (int i = 0; i < 40; i++) {
      receive("r1/kind" + i, "nonsense", NOW);
    }
    board.update(NOW.plusSeconds(1));
    receive("r1/range", "{\"stamp\":1,\"metres\":[1]}", NOW.plusSeconds(2));
    assertEquals(1, board.of("r1").readings().size());
  }

  @Test
  void presenceIsWhatTheRobotsClientSaid() {
    assertNull(board.of("r1").presence());
    receive("r1/connection", "online", NOW);
    receive("r1/connection", "online", NOW.plusSeconds(5));
    assertEquals(new ReadingBoard.Presence(true, NOW), board.of("r1").presence());
    receive("r1/connection", "offline", NOW.plusSeconds(9));
    assertEquals(new ReadingBoard.Presence(false, NOW.plusSeconds(9)), board.of("r1").presence());
  }

  @Test
  void robotThatIsRemovedIsForgotten() {
    receive("r1/range", "{\"stamp\":1,\"metres\":[1]}", NOW);
    robots.remove("r1");
    board.update(NOW.plusSeconds(1));
    assertEquals(ReadingBoard.RobotReadings.NONE, board.of("r1"));
  }

  @Test
  void readingBeyondItsLimitsIsSaid() {
    Reading range = new Reading("range", 1, NOW, List.of(0.2, 3.0), "m", List.of());
    assertEquals(
        Phrase.READING_BELOW.with("range", 0.2, " m", 0.3),
        new ReadingLimits("r1", "range", 0.3, null).violation(range).orElseThrow());
    assertEquals(
        Phrase.READING_ABOVE.with("range", 3.0, " m", 2.5),
        new ReadingLimits("r1", "range", 0.1, 2.5).violation(range).orElseThrow());
    assertTrue(new ReadingLimits("r1", "range", 0.2, 3.0).violation(range).isEmpty());
    assertFalse(new ReadingLimits("r1", "range", null, 1.0).isNone());
  }
}
