package org.toqa.agent.door;

import java.io.IOException;
import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.message.MessageReading.Understood;
import org.toqa.link.message.PairingMessage;
import org.toqa.link.message.PairingMessage.Pair;
import org.toqa.link.message.PairingMessage.Paired;
import org.toqa.link.message.PairingMessage.Unpaired;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.LinkSocket;
import org.toqa.link.trust.TimeLimit;

/**
 * The robot's side of pairing, one conversation a connection:
 *
 * <ol>
 *   <li>The server says {@code pair} with its proof.
 *   <li>If the code that is shown says so, the server's certificate is recorded.
 *   <li>Only then the robot says {@code paired} with its own proof; else {@code unpaired}, and why.
 * </ol>
 */
final class PairingDesk {

  private static final Logger log = LoggerFactory.getLogger(PairingDesk.class);
  private static final Duration LIMIT = Duration.ofSeconds(5);

  private final String robot;
  private final GuestList guests;
  private final Refusals refusals;
  private volatile @Nullable PairingOffer offer;

  /**
   * @param offer null: no code is shown
   */
  PairingDesk(String robot, GuestList guests, Refusals refusals, @Nullable PairingOffer offer) {
    this.robot = robot;
    this.guests = guests;
    this.refusals = refusals;
    this.offer = offer;
  }

  /** From now on this code is shown, in the place of any earlier one. */
  void show(PairingOffer newer) {
    offer = newer;
  }

  void converse(LinkSocket link) {
    try (link;
        TimeLimit _ = link.within(LIMIT)) {
      LineReader.Line line = new LineReader(link.in()).next();
      if (line != null
          && LinkCodec.pairingMessage(line)
              instanceof Understood<PairingMessage>(Pair(var proof))) {
        link.out().write(LinkCodec.line(answer(proof, link)));
      } else {
        refusals.note("What %s said to pair was not understood.", link.remote());
      }
    } catch (IOException e) {
      refusals.note("The pairing with %s was cut off.", link.remote());
    }
  }

  private PairingMessage answer(String proof, LinkSocket link) {
    Fingerprint server = Objects.requireNonNull(link.peer());
    PairingOffer open = offer;
    if (open == null) {
      return refused(robot + " shows no code; start its daemon with --pair.", link);
    }
    Optional<String> objection = open.objectionTo(proof, server);
    if (objection.isPresent()) {
      return refused(objection.get(), link);
    }
    try {
      guests.belongTo(server);
    } catch (IOException e) {
      return refused("The server cannot be recorded: " + e.getMessage(), link);
    }
    log.info("{}: paired with the server {} at {}.", robot, server, link.remote());
    return new Paired(robot, open.proofFor(server));
  }

  private Unpaired refused(String reason, LinkSocket link) {
    refusals.note("A pairing from %s was refused: " + reason, link.remote());
    return new Unpaired(reason);
  }
}
