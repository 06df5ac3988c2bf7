package org.toqa.agent.access;

import java.io.IOException;
import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.message.DecodeResult.Decoded;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
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
final class PairingHandler {

  private static final Logger log = LoggerFactory.getLogger(PairingHandler.class);
  private static final Duration LIMIT = Duration.ofSeconds(5);

  private final String robot;
  private final PeerPolicy policy;
  private final RejectedConnections rejected;
  private volatile @Nullable PairingOffer offer;

  /**
   * @param offer null: no code is shown
   */
  PairingHandler(
      String robot, PeerPolicy policy, RejectedConnections rejected, @Nullable PairingOffer offer) {
    this.robot = robot;
    this.policy = policy;
    this.rejected = rejected;
    this.offer = offer;
  }

  /** From now on this code is shown, in the place of any earlier one. */
  void setOffer(PairingOffer newer) {
    offer = newer;
  }

  void handle(LinkSocket link) {
    try (link;
        TimeLimit _ = link.startTimeLimit(LIMIT)) {
      LineReader.Line line = new LineReader(link.in()).readLine();
      if (line != null
          && LinkCodec.decodePairingMessage(line)
              instanceof Decoded<PairingMessage>(Pair request)) {
        link.out().write(LinkCodec.encode(answerTo(request, link)));
      } else {
        rejected.record("The pairing request of %s is not valid.", link.remoteAddress());
      }
    } catch (IOException e) {
      rejected.record("The pairing with %s was cut off.", link.remoteAddress());
    }
  }

  private PairingMessage answerTo(Pair request, LinkSocket link) {
    Fingerprint server = Objects.requireNonNull(link.peer());
    PairingOffer open = offer;
    if (open == null) {
      return reject(robot + " shows no code; start its daemon with --pair.", link);
    }
    Optional<String> objection = open.redeem(request.proof(), server);
    if (objection.isPresent()) {
      return reject(objection.get(), link);
    }
    if (request.robot() != null && !request.robot().equals(robot)) {
      return reject("The robot here is called %s, not %s.".formatted(robot, request.robot()), link);
    }
    try {
      policy.setServer(server);
    } catch (IOException e) {
      return reject("The server cannot be recorded: " + e.getMessage(), link);
    }
    log.info("{}: paired with the server {} at {}.", robot, server, link.remoteAddress());
    return new Paired(robot, open.proofFor(server));
  }

  private Unpaired reject(String reason, LinkSocket link) {
    rejected.record("A pairing from %s was refused: " + reason, link.remoteAddress());
    return new Unpaired(reason);
  }
}
