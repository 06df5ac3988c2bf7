package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.toqa.agent.firmware.FirmwareBuild;
import org.toqa.agent.firmware.SimulatorProbe;
import org.toqa.arm.ArmAction;
import org.toqa.arm.ArmStep;
import org.toqa.arm.JointAngles;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Ack;
import org.toqa.link.message.AgentMessage.Acted;
import org.toqa.link.message.AgentMessage.ArmState;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.AckActed;
import org.toqa.link.message.ServerMessage.Act;
import org.toqa.link.message.ServerMessage.Frame;
import org.toqa.link.message.ServerMessage.Ping;
import org.toqa.sim.SimulatedMicrocontroller;

/**
 * The daemon as a process of its own, over the firmware in the simulated chip, killed in the midst
 * of what its arm does: in real time, while the chip lives on.
 */
@Tag("full")
@Timeout(180)
class KilledArmIT {

  private static final Vec2 BOX = new Vec2(0.45, 0.1);

  @TempDir Path folder;

  private DaemonProcess launch(SimulatedMicrocontroller chip) throws IOException {
    Path config = folder.resolve("agent.yaml");
    Files.writeString(
        config,
        """
        name: r1
        port: 0
        dataDir: data
        maxLoad: 5
        arm: {}
        chassis: {type: simulated-firmware, socket: %s, start: {x: 1, y: 1}}
        """
            .formatted(chip.socket()));
    return DaemonProcess.launch(config);
  }

  private static Act act(long seq, ArmAction action) {
    return new Act(seq, 5, action == ArmAction.PICK ? 1 : 2, action, Frame.ROBOT, BOX, 1.5);
  }

  private static ArmState arm(State state) {
    return Objects.requireNonNull(state.arm());
  }

  private static void begin(DaemonProcess.Peer peer, Act act) throws IOException {
    peer.say(act);
    peer.await(Ack.class, ack -> ack.seq() == act.seq());
  }

  /** Nothing is dropped, nothing is grasped or put down twice, and only the server says go on. */
  @ParameterizedTest
  @EnumSource
  void killedWhilePickingUpItTellsThatItWasAndDoesTheRestWhenToldAnew(ArmStep step)
      throws Exception {
    ArmAction killedIn = ArmAction.PICK.steps().contains(step) ? ArmAction.PICK : ArmAction.PLACE;
    try (SimulatedMicrocontroller chip = FirmwareBuild.LM629_AT_16_MHZ.start(folder);
        SimulatorProbe probe = new SimulatorProbe(chip.socket())) {
      long seq = 0;
      JointAngles last;
      try (DaemonProcess daemon = launch(chip);
          DaemonProcess.Peer peer = daemon.connect()) {
        assertNotNull(peer.await(Hello.class, h -> true).arm());
        if (killedIn == ArmAction.PLACE) {
          begin(peer, act(++seq, ArmAction.PICK));
          Acted picked = peer.await(Acted.class, a -> true);
          assertEnd(picked, seq, ArmAction.PICK, 1.5);
          peer.say(new AckActed(seq));
        }
        begin(peer, act(++seq, killedIn));
        last = arm(peer.await(State.class, state -> arm(state).step() == step)).joints();
        daemon.kill();
      }
      try (DaemonProcess daemon = launch(chip);
          DaemonProcess.Peer peer = daemon.connect()) {
        Hello hello = peer.await(Hello.class, h -> true);
        assertEquals(5L, hello.task());
        assertNull(hello.act()); // it does nothing by itself
        assertNull(hello.acted());
        peer.say(new Ping(++seq));
        State state = peer.await(State.class, s -> true);
        assertEquals(
            "RESTARTED", state.errors().stream().map(Fault::code).findFirst().orElseThrow());
        assertEquals(0, arm(state).joints().minus(last).largest(), 0.8); // within 0.5 s at 90 deg/s
        JointAngles stands = arm(state).joints();
        State later = peer.await(State.class, s -> s.stamp() > state.stamp() + 1_000);
        assertEquals(0, arm(later).joints().minus(stands).largest(), 0.02);

        begin(peer, act(++seq, killedIn));
        assertEnd(
            peer.await(Acted.class, a -> true),
            seq,
            killedIn,
            killedIn == ArmAction.PICK ? 1.5 : null);
        peer.say(new AckActed(seq));
        boolean isHolding = killedIn == ArmAction.PICK;
        peer.await(State.class, s -> (arm(s).load() != null) == isHolding);
      }
      assertEquals(1, probe.truth().decimal("grasps"));
      assertEquals(killedIn == ArmAction.PICK ? 0 : 1, probe.truth().decimal("releases"));
    }
  }

  private static void assertEnd(Acted acted, long seq, ArmAction action, @Nullable Double weight) {
    assertEquals(seq, acted.act());
    assertEquals(action, acted.action());
    assertNull(acted.failure());
    if (weight == null) {
      assertNull(acted.weight());
    } else {
      assertEquals(weight, Objects.requireNonNull(acted.weight()), 0.01);
    }
  }
}
