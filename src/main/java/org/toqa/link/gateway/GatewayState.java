package org.toqa.link.gateway;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * A gateway as readers see it.
 *
 * @param isConnected whether it is now
 * @param since when that has changed last, or the server was started
 * @param address where it is connected from, as the server sees it; null: it is not
 */
public record GatewayState(
    String name, boolean isConnected, Instant since, @Nullable String address) {}
