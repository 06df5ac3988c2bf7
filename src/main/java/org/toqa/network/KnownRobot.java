package org.toqa.network;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * A robot of the fleet.
 *
 * @param place its host name or address, with its gateway
 * @param address in this server's own networks; null: it is asked by a name, or by a gateway
 * @param reachable whether it is connected; null: it has not been tried yet
 * @param heardAt null: never
 */
public record KnownRobot(
    String name,
    String place,
    @Nullable Ipv4Address address,
    @Nullable Boolean reachable,
    @Nullable Instant heardAt) {}
