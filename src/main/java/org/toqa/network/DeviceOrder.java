package org.toqa.network;

import org.jspecify.annotations.Nullable;

/**
 * What a manager says of a device.
 *
 * @param name of a robot its name in the fleet
 * @param hardware null: not known
 * @param address that it has or shall have; null: whichever it is given
 */
public record DeviceOrder(
    String name,
    DeviceKind kind,
    @Nullable HardwareAddress hardware,
    @Nullable Ipv4Address address) {}
