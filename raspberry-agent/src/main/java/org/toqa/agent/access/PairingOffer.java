package org.toqa.agent.access;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.PairingCode;
import org.toqa.link.trust.PairingProof;

/**
 * A code that is shown: good for ten minutes, for five wrong tries of each server, and for the
 * first server that knows it. That server may say it again, for the answer to its first time may
 * have been lost. Others void it for nobody but themselves; who changes his key for each try still
 * has to guess 50 bits in ten minutes.
 */
final class PairingOffer {

  static final Duration VALIDITY = Duration.ofMinutes(10);

  private static final int MAX_WRONG_TRIES = 5;

  /** Whose wrong tries are remembered. */
  private static final int MAX_SERVERS = 1000;

  private final PairingCode code;
  private final Fingerprint robot;
  private final LongSupplier nanos;
  private final long shownNanos;
  private final Map<Fingerprint, Integer> wrongTries =
      new LinkedHashMap<>() {
        @Override
        protected boolean removeEldestEntry(Map.Entry<Fingerprint, Integer> eldest) {
          return size() > MAX_SERVERS;
        }
      };
  private @Nullable Fingerprint redeemer;

  /**
   * @param nanos what time it is, on a monotonic clock
   */
  PairingOffer(PairingCode code, Fingerprint robot, LongSupplier nanos) {
    this.code = code;
    this.robot = robot;
    this.nanos = nanos;
    this.shownNanos = nanos.getAsLong();
  }

  String text() {
    return code.text();
  }

  /**
   * Tries a proof.
   *
   * @param server who has shown it
   * @return why it is refused, a sentence; empty where the code is this server's from now on
   */
  synchronized Optional<String> redeem(String proof, Fingerprint server) {
    if (nanos.getAsLong() - shownNanos > VALIDITY.toNanos()) {
      return objection("The code has run out after %d minutes".formatted(VALIDITY.toMinutes()));
    }
    int wrongBefore = wrongTries.getOrDefault(server, 0);
    if (wrongBefore >= MAX_WRONG_TRIES) {
      return objection("The code is void after %d wrong tries".formatted(MAX_WRONG_TRIES));
    }
    if (!PairingProof.SERVER.isValid(proof, code, robot, server)) {
      int wrong = wrongBefore + 1;
      wrongTries.put(server, wrong);
      return wrong == MAX_WRONG_TRIES
          ? objection("The code is wrong, and void after %d wrong tries".formatted(MAX_WRONG_TRIES))
          : Optional.of("The code is wrong; tries left: %d.".formatted(MAX_WRONG_TRIES - wrong));
    }
    if (redeemer != null && !redeemer.equals(server)) {
      return objection("The code was used by another server");
    }
    redeemer = server;
    return Optional.empty();
  }

  /** That the robot knows the code too; only for a peer that has proved to know it. */
  String proofFor(Fingerprint server) {
    return PairingProof.ROBOT.of(code, robot, server);
  }

  private static Optional<String> objection(String why) {
    return Optional.of(why + "; start the robot's daemon with --pair for a new one.");
  }
}
