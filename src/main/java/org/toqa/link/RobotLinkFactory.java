package org.toqa.link;

import org.toqa.link.trust.PairingCode;

/** Opens links to robots. */
public interface RobotLinkFactory {

  RobotLink open(RobotAddress address, RobotLink.Listener listener);

  /**
   * Shows a robot that this server knows the code that it shows, so that each records the other's
   * certificate. Waits, for some seconds at most.
   *
   * @param robot the name that it must say
   * @param port of TCP, 1 to 65535
   * @return a refusal, with its reason, wherever it does not come about
   */
  PairingResult pair(String robot, String host, int port, PairingCode code);
}
