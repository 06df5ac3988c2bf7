package org.toqa.agent.door;

import java.time.Duration;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.PairingCode;
import org.toqa.link.trust.PairingProof;

/**
 * A code that is shown: good for ten minutes, for five wrong tries, and for the first server that
 * knows it. That server may say it again, for the answer to its first time may have been lost.
 */
final class PairingOffer {

  static final Duration LIFE = Duration.ofMinutes(10);

  private static final int TRIES = 5;

  private final PairingCode code;
  private final Fingerprint robot;
  private final LongSupplier nanos;
  private final long begin;
  private int wrong;
  private @Nullable Fingerprint taker;

  /**
   * @param nanos what time it is, on a monotonic clock
   */
  PairingOffer(PairingCode code, Fingerprint robot, LongSupplier nanos) {
    this.code = code;
    this.robot = robot;
    this.nanos = nanos;
    this.begin = nanos.getAsLong();
  }

  String shown() {
    return code.shown();
  }

  /**
   * Tries a proof.
   *
   * @param server who has shown it
   * @return why it is refused, a sentence; empty where the code is this server's from now on
   */
  synchronized Optional<String> objectionTo(String proof, Fingerprint server) {
    if (nanos.getAsLong() - begin > LIFE.toNanos()) {
      return no("The code has run out after %d minutes".formatted(LIFE.toMinutes()));
    }
    if (wrong >= TRIES) {
      return no("The code is void after %d wrong tries".formatted(TRIES));
    }
    if (!PairingProof.SERVER.isShownBy(proof, code, robot, server)) {
      wrong++;
      return wrong == TRIES
          ? no("The code is wrong, and void after %d wrong tries".formatted(TRIES))
          : Optional.of("The code is wrong; tries left: %d.".formatted(TRIES - wrong));
    }
    if (taker != null && !taker.equals(server)) {
      return no("The code was used by another server");
    }
    taker = server;
    return Optional.empty();
  }

  /** That the robot knows the code too; to be told to nobody but who has proved to know it. */
  String proofFor(Fingerprint server) {
    return PairingProof.ROBOT.of(code, robot, server);
  }

  private static Optional<String> no(String why) {
    return Optional.of(why + "; start the robot's daemon with --pair for a new one.");
  }
}
