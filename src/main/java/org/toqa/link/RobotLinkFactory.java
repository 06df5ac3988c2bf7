package org.toqa.link;

import java.util.List;
import org.toqa.link.gateway.GatewayState;
import org.toqa.link.trust.PairingCode;

/** Opens links to robots. */
public interface RobotLinkFactory {

  RobotLink open(RobotAddress address, RobotLink.Listener listener);

  /**
   * Shows a robot that this server knows the code that it shows, so that each records the other's
   * certificate. Waits, for some seconds at most.
   *
   * @param robot where it is, and the name that it must say; it is not known yet what it is known
   *     by
   * @return a refusal, with its reason, wherever it does not come about
   */
  PairingResult pair(RobotAddress robot, PairingCode code);

  /** The gateways that links can go through. */
  default List<GatewayState> gateways() {
    return List.of();
  }
}
