package org.toqa.network;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** Who answered on this machine's own networks (ARP), as Linux keeps it. */
final class NeighbourTable {
  private static final Path FILE = Path.of("/proc/net/arp");

  /** The flag of an entry that was answered. */
  private static final int COMPLETE = 2;

  private NeighbourTable() {}

  /** Empty where the system has no such table. */
  static Map<Ipv4Address, HardwareAddress> read() {
    try {
      return parse(Files.readString(FILE));
    } catch (IOException e) {
      return Map.of();
    }
  }

  static Map<Ipv4Address, HardwareAddress> parse(String table) {
    Map<Ipv4Address, HardwareAddress> neighbours = new HashMap<>();
    table
        .lines()
        .skip(1) // the heading
        .map(line -> line.strip().split(" +", -1))
        .filter(fields -> fields.length > 3 && fields[2].matches("0x[0-9a-f]{1,4}"))
        .filter(fields -> (Integer.decode(fields[2]) & COMPLETE) != 0)
        .forEach(
            fields -> {
              Optional<Ipv4Address> address = Ipv4Address.parse(fields[0]);
              Optional<HardwareAddress> hardware = HardwareAddress.parse(fields[3]);
              if (address.isPresent() && hardware.isPresent()) {
                neighbours.put(address.get(), hardware.get());
              }
            });
    return Map.copyOf(neighbours);
  }
}
