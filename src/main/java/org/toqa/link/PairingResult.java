package org.toqa.link;

import org.toqa.link.trust.Fingerprint;
import org.toqa.wording.Sentence;

/** What came of the attempt to pair with a robot. */
public sealed interface PairingResult {

  /**
   * The robot has recorded this server.
   *
   * @param robot of its certificate
   */
  record Paired(Fingerprint robot) implements PairingResult {}

  /** The code is not the robot's, or not any more. */
  record Refused(Sentence sentence) implements PairingResult {}

  /** No robot that pairs was found there. */
  record Unreachable(Sentence sentence) implements PairingResult {}
}
