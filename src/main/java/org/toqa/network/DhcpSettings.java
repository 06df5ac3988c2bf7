package org.toqa.network;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;

/**
 * A dnsmasq that serves addresses.
 *
 * @param subnet that it serves
 * @param hosts its dhcp-hostsfile, which this server writes
 * @param leases its dhcp-leasefile
 * @param pid its pid-file, by which it is made to read {@code hosts} again; null: somebody else
 *     does that
 */
public record DhcpSettings(Subnet subnet, Path hosts, Path leases, @Nullable Path pid) {}
