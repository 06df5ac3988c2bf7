package org.toqa.agent.access;

import java.net.InetAddress;
import java.nio.file.Path;
import java.util.function.LongSupplier;

/**
 * What an endpoint is opened with.
 *
 * @param address to listen on
 * @param port of TCP to listen on, 0 to 65535; 0 for any free one
 * @param plainOffLoopback whether the link of a robot that was never paired may do without
 *     encryption off loopback too
 * @param folder of the key and of the server's certificate
 * @param showCode whether a code is to be shown
 * @param nanos what time it is, nanoseconds on a monotonic clock
 */
public record LinkEndpointConfig(
    String robot,
    InetAddress address,
    int port,
    boolean plainOffLoopback,
    Path folder,
    boolean showCode,
    LongSupplier nanos) {

  boolean canBePlain() {
    return address.isLoopbackAddress() || plainOffLoopback;
  }
}
