package org.toqa.network;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/**
 * The DHCP server dnsmasq, which the system runs: this server writes the file of its reservations,
 * makes it read that file again, and reads its leases. It is told of nothing else, so that whoever
 * takes over this server takes over no more than addresses (docs/decisions/dhcp.md).
 *
 * <p>One thread writes; any may read leases.
 */
final class Dnsmasq {
  private static final String NAME = "dnsmasq";
  private static final String HEADING =
      "# Reservations of Toqa: made on its page Network, and written anew at each change.\n";

  /** Bytes: of some ten thousand leases. */
  private static final int LONGEST_LEASES = 1 << 20;

  private static final Duration SIGNAL_LIMIT = Duration.ofSeconds(5);

  private final DhcpSettings settings;

  /** Whether it has not been made to read what is written; also after a start, since who knows. */
  private boolean isUnread = true;

  Dnsmasq(DhcpSettings settings) {
    this.settings = settings;
  }

  Subnet subnet() {
    return settings.subnet();
  }

  /**
   * Those that have not ended.
   *
   * @throws IOException they cannot be read
   */
  List<Lease> leases(Instant now) throws IOException {
    try (var file = Files.newInputStream(settings.leases())) {
      byte[] read = file.readNBytes(LONGEST_LEASES);
      return LeaseFile.parse(new String(read, StandardCharsets.UTF_8), now);
    }
  }

  Path leaseFile() {
    return settings.leases();
  }

  /**
   * From now on it serves these addresses to these devices, and no others that were reserved.
   *
   * @return why not
   */
  Optional<DhcpTrouble> publish(List<Device> devices) {
    String text = reservations(devices);
    try {
      if (!text.equals(written())) {
        write(text);
        isUnread = true;
      }
    } catch (IOException e) {
      return trouble(DhcpTrouble.Kind.HOSTS_NOT_WRITTEN, settings.hosts().toString());
    }
    Path pid = settings.pid();
    if (!isUnread || pid == null) {
      return Optional.empty();
    }
    Optional<DhcpTrouble> trouble = tell(pid);
    isUnread = trouble.isPresent();
    return trouble;
  }

  /**
   * Addresses only, and no names: dnsmasq would take some of them for words of its own, such as
   * {@code ignore} or {@code 12h}.
   */
  static String reservations(List<Device> devices) {
    return devices.stream()
        .filter(Device::isReservable)
        .map(device -> "%s,%s\n".formatted(device.hardware(), device.address()))
        .collect(Collectors.joining("", HEADING, ""));
  }

  /** Null: nothing yet. */
  private @Nullable String written() throws IOException {
    return Files.exists(settings.hosts()) ? Files.readString(settings.hosts()) : null;
  }

  /** All at once: dnsmasq never reads a half of it. It may run as another user, who reads it. */
  private void write(String text) throws IOException {
    Path next = settings.hosts().resolveSibling(settings.hosts().getFileName() + ".next");
    Files.writeString(next, text);
    Files.setPosixFilePermissions(next, PosixFilePermissions.fromString("rw-r--r--"));
    Files.move(next, settings.hosts(), StandardCopyOption.ATOMIC_MOVE);
  }

  /** Reads its files again (SIGHUP). A pid-file that was left behind may name any process. */
  private static Optional<DhcpTrouble> tell(Path pidFile) {
    String pid;
    try {
      pid = Files.readString(pidFile).strip();
      if (!pid.matches("[1-9][0-9]{0,9}")
          || !Files.readString(Path.of("/proc", pid, "comm")).strip().equals(NAME)) {
        return trouble(DhcpTrouble.Kind.NOT_RUNNING, pidFile.toString());
      }
    } catch (IOException e) {
      return trouble(DhcpTrouble.Kind.NOT_RUNNING, pidFile.toString());
    }
    return hangUp(pid) ? Optional.empty() : trouble(DhcpTrouble.Kind.NOT_TOLD, pid);
  }

  private static boolean hangUp(String pid) {
    try {
      Process kill =
          new ProcessBuilder("/bin/sh", "-c", "kill -HUP " + pid)
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .start();
      if (kill.waitFor(SIGNAL_LIMIT.toSeconds(), TimeUnit.SECONDS)) {
        return kill.exitValue() == 0;
      }
      kill.destroyForcibly();
      return false;
    } catch (IOException e) {
      return false;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  private static Optional<DhcpTrouble> trouble(DhcpTrouble.Kind kind, String what) {
    return Optional.of(new DhcpTrouble(kind, what));
  }
}
