package org.toqa.link;

import org.toqa.link.trust.Fingerprint;

/** What came of the attempt to pair with a robot. */
public sealed interface PairingResult {

  /**
   * The robot has recorded this server.
   *
   * @param robot of its certificate
   */
  record Paired(Fingerprint robot) implements PairingResult {}

  /**
   * The code is not the robot's, or not any more.
   *
   * @param sentence for people
   */
  record Refused(String sentence) implements PairingResult {}

  /**
   * No robot that pairs was found there.
   *
   * @param sentence for people
   */
  record Unreachable(String sentence) implements PairingResult {}
}
