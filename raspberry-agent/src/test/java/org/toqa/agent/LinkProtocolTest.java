package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.config.AgentConfig;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Ping;

/** How a daemon treats peers of every kind. */
class LinkProtocolTest extends ConnectedRobotTest {
  @Test
  void stateComesFiveTimesASecond() {
    server.synchronise();
    int before = server.received(State.class).size();
    rig.advance(Duration.ofSeconds(10));

    assertEquals(50, server.received(State.class).size() - before);
  }

  @Test
  void changeIsToldAtOnce() {
    server.assertAccepted(TestServer.drive(1, 5L, 1, Rig.START, List.of(METRE)));
    rig.advance(Chassis.TICK);

    assertEquals(Mode.DRIVING, server.state().mode());
  }

  @Test
  void unknownTypeIsRefusedAndTheConnectionGoesOn() {
    assertTrue(
        server
            .rejectReasonOfLine("{\"type\":\"fly\",\"seq\":3}")
            .startsWith("The type \"fly\" is not"));
    server.synchronise();
  }

  @Test
  void aWebPageThatPostsACommandIsNotObeyed() throws Exception {
    server.send("POST / HTTP/1.1\r\nHost: localhost\r\n\r\n".getBytes(StandardCharsets.UTF_8));

    server.awaitEnd();
  }

  @Test
  void unknownFieldIsIgnored() {
    String drive =
        """
        {"type":"drive","seq":1,"task":5,"phase":1,"start":{"x":2,"y":3,"theta":0,"z":9},\
        "segments":[{"v":0.25,"w":0,"t":4,"colour":"red"}],"released":1,"final":true,"urgent":1}
        """;
    server.send(drive.getBytes(StandardCharsets.UTF_8));
    server.synchronise();

    assertEquals(Mode.DRIVING, server.state().mode());
  }

  @Test
  void lineOfAMegabyteIsRefusedAndTheConnectionGoesOn() {
    String reason = server.rejectReasonOfLine("x".repeat(1_000_000));

    assertEquals(
        "The line has 1000001 bytes; a line has at most 65536. Send a longer path by extend.",
        reason);
    server.synchronise();
  }

  @Test
  void garbageIsRefusedAndMovesNothing() {
    SplittableRandom random = new SplittableRandom(11);
    for (int i = 0; i < 50; i++) {
      byte[] garbage = new byte[1 + random.nextInt(2_000)];
      random.nextBytes(garbage);
      server.send(garbage);
    }
    server.send(new byte[] {'\n'});
    server.advance(Duration.ofSeconds(1));

    assertEquals(Mode.IDLE, server.state().mode());
    assertEquals(Rig.START, server.pose());
  }

  @Test
  void lineThatIsCutOffHasNoEffect() {
    String drive =
        """
        {"type":"drive","seq":1,"task":5,"phase":1,"start":{"x":2,"y":3,"theta":0},\
        "segments":[{"v":0.25,"w":0,"t":4}],"released":1,"final":true}""";
    server.send(drive.getBytes(StandardCharsets.UTF_8)); // whole but for its line feed
    server.close();
    rig.advance(Duration.ofSeconds(2));

    TestServer next = rig.connect();
    assertEquals(Mode.IDLE, next.hello().mode());
    assertEquals(0, next.hello().lastSeq());
  }

  @Test
  void newerConnectionReplacesTheOlder() {
    server.synchronise();
    TestServer newer = rig.connect();
    newer.synchronise();
    server.awaitEnd();

    newer.assertAccepted(TestServer.drive(1, 5L, 1, Rig.START, List.of(METRE)));
  }

  @Test
  void robotDrivesOnWhileItsServerConnectsAnew() {
    server.assertAccepted(TestServer.drive(1, 5L, 1, Rig.START, List.of(METRE)));
    server.advance(Duration.ofSeconds(1));
    server.close();
    rig.advance(Duration.ofSeconds(1));

    TestServer newer = rig.connect();
    assertEquals(Mode.DRIVING, newer.hello().mode());
    assertEquals(1, newer.hello().drive());
    assertEquals(1, newer.hello().released());
    assertEquals(5L, newer.hello().task());
  }

  @Test
  void serverThatDoesNotListenIsDroppedAndHoldsNothingUp() {
    TestServer deaf = rig.connectWithoutReading();
    deaf.send(new Ping(1));
    rig.tickWithoutTime();
    // 5 states a second fill the socket's buffers and the queue of 300 lines
    rig.advance(Duration.ofHours(2));

    deaf.startReading();
    deaf.awaitEnd();
    rig.connect().synchronise();
  }

  @Test
  void waitingServerHoldsTheWorldUpOnlyWhenNothingIsLeftToHear() {
    server.synchronise();
    rig.advance(Duration.ofMillis(900));
    assertFalse(rig.isWaitingForServer());
    rig.advance(Duration.ofMillis(200));
    assertTrue(rig.isWaitingForServer());
    server.synchronise();
    assertFalse(rig.isWaitingForServer());
    rig.advance(Duration.ofMillis(1_900));
    assertTrue(rig.isWaitingForServer());
    rig.advance(Duration.ofMillis(200));
    assertFalse(rig.isWaitingForServer(), "a server that is silent for good");
  }

  @Test
  void strangerThatSaysNothingIsNotWaitedForForEver() {
    server.synchronise();
    server.close();
    rig.advance(Duration.ofSeconds(1));
    TestServer stranger = rig.connect();
    rig.advance(Duration.ofMillis(1_500));
    assertTrue(rig.isWaitingForServer(), "it may be the server");
    rig.advance(Duration.ofSeconds(1));
    assertFalse(rig.isWaitingForServer());
    stranger.close();
  }

  @Test
  void portInUseIsToldInOneLine() throws IOException {
    try (ServerSocket taken = new ServerSocket(0)) {
      AgentConfig config = rig.config(folder.resolve("other"), taken.getLocalPort());

      IOException e =
          assertThrows(IOException.class, () -> Daemon.open(config, InstantSource.system(), 0));
      assertEquals(
          "Port %d on 127.0.0.1 cannot be listened on (Address already in use);"
                  .formatted(taken.getLocalPort())
              + " is another daemon running there?",
          e.getMessage());
    }
  }

  @Test
  void dataFolderHasOneDaemon() {
    IOException e =
        assertThrows(IOException.class, () -> Daemon.open(rig.config(), InstantSource.system(), 0));

    assertEquals("The data folder " + folder + " is in use by another daemon.", e.getMessage());
  }
}
