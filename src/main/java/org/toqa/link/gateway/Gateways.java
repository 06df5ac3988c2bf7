package org.toqa.link.gateway;

import java.util.List;
import org.toqa.link.trust.LinkSocket;

/** The gateways of a server. */
public interface Gateways {

  /** Of a server that has none. */
  Gateways NONE =
      new Gateways() {
        @Override
        public LinkSocket open(String gateway, String host, int port) throws GatewayException {
          throw new GatewayException(GatewayException.Reason.UNKNOWN_GATEWAY, "");
        }

        @Override
        public List<GatewayState> states() {
          return List.of();
        }
      };

  /**
   * A connection to a robot; waits for it, for some seconds at most.
   *
   * @param host as the gateway's network knows it
   * @param port of TCP
   * @return bytes to and from the robot, and nothing said yet
   */
  LinkSocket open(String gateway, String host, int port) throws GatewayException;

  /** All that the configuration names, in its order. */
  List<GatewayState> states();
}
