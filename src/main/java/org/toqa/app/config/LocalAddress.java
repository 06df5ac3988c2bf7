package org.toqa.app.config;

import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.net.UnknownHostException;

/** Addresses at which this machine can listen. */
final class LocalAddress {
  private LocalAddress() {}

  /**
   * @param text a host name or an IP address
   * @throws UnknownHostException there is none such, or it is another machine's
   */
  static InetAddress parse(String text) throws UnknownHostException {
    InetAddress address = InetAddress.getByName(text);
    if (!isOfThisMachine(address)) {
      throw new UnknownHostException(text);
    }
    return address;
  }

  private static boolean isOfThisMachine(InetAddress address) {
    try {
      return address.isAnyLocalAddress()
          || address.isLoopbackAddress()
          || NetworkInterface.getByInetAddress(address) != null;
    } catch (SocketException _) {
      return true; // nobody can say: who listens there will see
    }
  }
}
