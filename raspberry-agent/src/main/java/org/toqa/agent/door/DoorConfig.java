package org.toqa.agent.door;

import java.net.InetAddress;
import java.nio.file.Path;
import java.util.function.LongSupplier;

/**
 * What a door is told.
 *
 * @param address to listen on
 * @param port to listen on; 0 for any free one
 * @param plainOffLoopback whether the link of a robot that was never paired may do without
 *     encryption off loopback too
 * @param folder of the key and of the server's certificate
 * @param pair whether a code is to be shown
 * @param nanos what time it is, on a monotonic clock
 */
public record DoorConfig(
    String robot,
    InetAddress address,
    int port,
    boolean plainOffLoopback,
    Path folder,
    boolean pair,
    LongSupplier nanos) {

  boolean mayBePlain() {
    return address.isLoopbackAddress() || plainOffLoopback;
  }
}
