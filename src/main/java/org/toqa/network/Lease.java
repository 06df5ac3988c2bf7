package org.toqa.network;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * An address that the DHCP server gave to a device.
 *
 * @param until null: it has no end
 * @param hostName as the device calls itself; null: it does not say, or not in letters, digits,
 *     dots, hyphens and underscores
 */
public record Lease(
    HardwareAddress hardware,
    Ipv4Address address,
    @Nullable Instant until,
    @Nullable String hostName) {}
