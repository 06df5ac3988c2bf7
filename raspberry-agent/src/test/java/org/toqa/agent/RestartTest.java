package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.chassis.SimulatedChassis;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage.Ack;
import org.toqa.link.message.AgentMessage.Done;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.PhaseEnd;
import org.toqa.link.message.ServerMessage.Cancel;
import org.toqa.link.message.ServerMessage.Hold;
import org.toqa.link.message.ServerMessage.Locate;
import org.toqa.motion.Segment;

/** What a daemon knows after it was started anew over its journal and its body. */
class RestartTest extends ConnectedRobotTest {
  @Test
  void driveUnderWayIsGivenUpButNotItsTask() {
    server.assertAccepted(TestServer.drive(7, 5L, 2, Rig.START, List.of(METRE, METRE, METRE)));
    server.advance(Duration.ofSeconds(6));
    Pose before = server.pose();
    rig.restart();
    TestServer again = rig.connect();

    Hello hello = again.hello();
    assertEquals(0, hello.drive());
    assertEquals(5L, hello.task());
    assertEquals(2, hello.phase());
    assertEquals(7, hello.lastSeq());
    assertNull(hello.done());
    assertTrue(hello.localised());
    assertEquals(Mode.IDLE, hello.mode());
    assertEquals(
        List.of(
            new Fault(
                "RESTARTED",
                "The daemon was restarted during drive 7, after 1 of its segments; it waits for a"
                    + " new drive.")),
        again.state().errors());
    // it rolled out and has stopped
    assertTrue(hello.pose().x() > before.x() && hello.pose().x() < before.x() + 0.1);
    again.advance(Duration.ofSeconds(2));
    assertEquals(hello.pose(), again.pose());
  }

  @Test
  void newDriveLeadsOnFromWhereTheRobotStands() {
    server.assertAccepted(TestServer.drive(7, 5L, 2, Rig.START, List.of(METRE, METRE)));
    server.advance(Duration.ofSeconds(3));
    rig.restart();
    TestServer again = rig.connect();
    Pose here = again.hello().pose();
    again.assertAccepted(TestServer.drive(8, 5L, 2, here, List.of(METRE)));
    again.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);

    assertEquals(new Done(5L, 2, 8), again.received(Done.class).getFirst());
    assertEquals(here.x() + 1, again.pose().x(), 0.002);
    assertEquals(List.of(), again.state().errors());
  }

  @Test
  void placeIsKnownAgainWithinMillimetres() {
    Segment turn = new Segment(0, 1, 2);
    server.assertAccepted(TestServer.drive(7, 5L, 1, Rig.START, List.of(METRE, turn, METRE)));
    server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);
    Pose before = server.pose();
    rig.restart();

    DrivingTest.assertNear(before, rig.connect().hello().pose(), 0.001, 0.002);
  }

  @Test
  void endThatWasNotAcknowledgedIsToldAgain() {
    server.assertAccepted(TestServer.drive(7, 5L, 1, Rig.START, List.of()));
    server.advance(Duration.ofMillis(500));
    rig.restart();
    TestServer again = rig.connect();

    assertEquals(new PhaseEnd(5L, 1, 7), again.hello().done());
    again.advance(Duration.ofMillis(1_500));
    assertEquals(List.of(new Done(5L, 1, 7)), again.received(Done.class));
    again.acknowledge(7);
    rig.restart();
    assertNull(rig.connect().hello().done());
  }

  @Test
  void commandFromBeforeIsNotObeyedTwice() {
    server.assertAccepted(TestServer.drive(7, 5L, 1, Rig.START, List.of(METRE)));
    server.assertAccepted(new Cancel(8, 5L));
    server.advance(Duration.ofSeconds(1));
    rig.restart();
    TestServer again = rig.connect();

    assertEquals(8, again.hello().lastSeq());
    assertNull(again.hello().task());
    assertEquals(
        new Ack(7), again.ask(TestServer.drive(7, 5L, 1, again.hello().pose(), List.of(METRE))));
    again.advance(Duration.ofSeconds(1));
    assertEquals(Mode.IDLE, again.state().mode());
  }

  @Test
  void holdOutlastsTheDaemon() {
    server.assertAccepted(new Hold(1));
    rig.restart();

    assertEquals(Mode.HOLDING, rig.connect().hello().mode());
  }

  @Test
  void robotThatLostItsPowerDrivesNothingUntilItIsToldWhereItIs() throws IOException {
    server.assertAccepted(TestServer.drive(1, 5L, 1, Rig.START, List.of(METRE)));
    server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);
    rig.closeDaemon();
    cyclePower();
    rig.reopen();
    TestServer again = rig.connect();

    assertFalse(again.hello().localised());
    assertEquals(
        "The robot does not know where it is; send locate first.",
        again.rejectReason(TestServer.drive(2, 5L, 2, again.hello().pose(), List.of(METRE))));
    Pose dock = new Pose(10, 1, 0);
    again.assertAccepted(new Locate(3, dock));
    again.assertAccepted(TestServer.drive(4, 5L, 2, dock, List.of(METRE)));
    again.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);
    assertEquals(11, again.pose().x(), 0.002);
  }

  @Test
  void journalThatCannotBeReadIsPutAside() throws IOException {
    rig.closeDaemon();
    Files.writeString(folder.resolve("journal.json"), "{\"powerCycle\":");
    rig.reopen();

    assertTrue(rig.connect().hello().localised(), "the new body's place is known all the same");
    assertTrue(Files.exists(folder.resolve("journal.broken")));
  }

  @Test
  void commandThatCannotBeWrittenDownIsRefused() throws IOException {
    Files.createDirectory(folder.resolve("journal.json.next")); // where a file is to be written

    assertEquals(
        "The robot cannot write its journal, so it did nothing.",
        server.rejectReason(TestServer.drive(1, 5L, 1, Rig.START, List.of(METRE))));
    server.advance(Duration.ofSeconds(1));
    assertEquals(Rig.START, server.pose());
    assertEquals("JOURNAL", server.state().errors().getFirst().code());

    Files.delete(folder.resolve("journal.json.next"));
    server.assertAccepted(TestServer.drive(1, 5L, 1, Rig.START, List.of(METRE)));
    assertEquals(List.of(), server.state().errors());
  }

  private void cyclePower() throws IOException {
    try (SimulatedChassis body =
        new SimulatedChassis(folder.resolve("body"), Rig.START, SimulatedBattery.FULL, 0, 7)) {
      body.cyclePower();
    }
  }
}
