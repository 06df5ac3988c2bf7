package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CompletionStage;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.PairingCode;

/** What people change while a robot is being paired, which takes its time. */
class FleetPairingTest extends HallFleetTest {
  private static final Fingerprint SHOWN = new Fingerprint("a".repeat(64));
  private static final PairingCode CODE = PairingCode.parse("A".repeat(26)).orElseThrow();

  @BeforeEach
  void startPairing() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    stage.setPairingFingerprint(SHOWN);
    stage.stopPairing(true);
  }

  @Test
  void aChangeThatWasMadeMeanwhileStays() throws Exception {
    CompletionStage<Answer<RobotView>> pairing = pair("r2");
    accepted(stage.fleet.changeRobot("r2", new RobotChange("127.0.0.1", 1, 3, null), "Boss"));

    stage.stopPairing(false);

    RobotRecord paired = accepted(pairing).record();
    assertEquals(SHOWN, paired.fingerprint());
    assertEquals(3, paired.maxLoad());
    assertNull(paired.parking());
    assertEquals(paired, stored("r2"));
  }

  @Test
  void anAddressThatWasChangedMeanwhileStays() throws Exception {
    CompletionStage<Answer<RobotView>> pairing = pair("r2");
    accepted(stage.fleet.changeRobot("r2", new RobotChange("127.0.0.1", 2, 5, "P2"), "Boss"));

    stage.stopPairing(false);

    assertInstanceOf(Answer.Outdated.class, answer(pairing));
    assertEquals(2, stored("r2").port());
    assertNull(stored("r2").fingerprint());
  }

  @Test
  void aRobotThatWasRemovedMeanwhileStaysSo() throws Exception {
    CompletionStage<Answer<RobotView>> pairing = pair("r2");
    accepted(stage.fleet.takeOutOfService("r2", "Boss"));
    accepted(stage.fleet.removeRobot("r2", "Boss"));

    stage.stopPairing(false);

    assertInstanceOf(Answer.Unknown.class, answer(pairing));
    assertTrue(stage.store.robots().stream().noneMatch(r -> r.name().equals("r2")));
  }

  @Test
  void aRobotThatIsBeingPairedForTheFirstTimeCannotBeChanged() throws Exception {
    CompletionStage<Answer<RobotView>> adding =
        stage.fleet.addRobot(new RobotOrder("r1b", "127.0.0.1", 1, 5, null, CODE), "Max");
    assertInstanceOf(
        Answer.Unknown.class,
        answer(stage.fleet.changeRobot("r1b", new RobotChange("127.0.0.1", 2, 9, null), "Boss")));
    assertEquals(2, stage.store.robots().size());
    assertTrue(history("robot.changed").isEmpty());
    assertFalse(adding.toCompletableFuture().isDone());
  }

  private CompletionStage<Answer<RobotView>> pair(String robot) throws InterruptedException {
    CompletionStage<Answer<RobotView>> pairing =
        stage.fleet.pairRobot(robot, new PairingOrder("127.0.0.1", 1, CODE), "Max");
    stage.awaitQuiescence();
    return pairing;
  }

  private RobotRecord stored(String robot) {
    return stage.store.robots().stream()
        .filter(r -> r.name().equals(robot))
        .findFirst()
        .orElseThrow();
  }
}
