package org.toqa.agent.config;

import java.io.IOException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * The ad hoc network of a robot that forwards for others and is reached through others.
 *
 * @param interfaces of the machine, over which it hears the others, such as {@code wlan0}
 * @param helloSeconds between its greetings, by which the others know that they hear it
 * @param key that all nodes have, 64 hexadecimal digits; null: whoever is in reach may route
 */
public record AdHocNetwork(List<String> interfaces, double helloSeconds, @Nullable String key) {

  private static final int MOST_INTERFACES = 8;
  private static final Pattern INTERFACE = Pattern.compile("[A-Za-z0-9][A-Za-z0-9._-]{0,14}");
  private static final Pattern KEY = Pattern.compile("[0-9a-fA-F]{64}");
  private static final Set<PosixFilePermission> OF_OTHERS =
      Set.of(PosixFilePermission.OTHERS_READ, PosixFilePermission.OTHERS_WRITE);

  public AdHocNetwork {
    interfaces = List.copyOf(interfaces);
  }

  /**
   * @param file of the configuration; a relative path in it counts from there
   * @param top its whole content
   * @return null: the robot is in no such network
   */
  static @Nullable AdHocNetwork read(Path file, ConfigSection top) throws ConfigException {
    if (!top.has("adHocNetwork")) {
      return null;
    }
    ConfigSection network = top.section("adHocNetwork", "interfaces", "hello", "key");
    List<String> interfaces = network.texts("interfaces");
    if (interfaces.isEmpty()
        || interfaces.size() > MOST_INTERFACES
        || !interfaces.stream().allMatch(name -> INTERFACE.matcher(name).matches())) {
      throw network.invalid("interfaces", interfaces, "1 to 8 network interfaces, as in [wlan0]");
    }
    return new AdHocNetwork(
        interfaces,
        network.number("hello", 1, 0.1, 60),
        network.has("key")
            ? key(network, file.toAbsolutePath().resolveSibling(network.text("key")).normalize())
            : null);
  }

  private static String key(ConfigSection network, Path file) throws ConfigException {
    String content;
    try {
      content = Files.readString(file).strip();
      if (FileSystems.getDefault().supportedFileAttributeViews().contains("posix")
          && Files.getPosixFilePermissions(file).stream().anyMatch(OF_OTHERS::contains)) {
        throw network.invalid(
            "key", file, "a file that nobody else may read or write (chmod o-rw)");
      }
    } catch (IOException e) {
      throw network.invalid("key", file, "a file that can be read");
    }
    if (!KEY.matcher(content).matches()) {
      throw network.invalid(
          "key", file, "a file with 64 hexadecimal digits, as openssl rand -hex 32 makes them");
    }
    return content;
  }
}
