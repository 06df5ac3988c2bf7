package org.toqa.app.gateway;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.app.config.ConfigurationException;
import org.toqa.link.gateway.AllowedAddresses;
import org.toqa.link.gateway.GatewayAgent.Server;
import org.toqa.link.trust.Fingerprint;
import org.toqa.yaml.Spelling;
import org.toqa.yaml.YamlParser;
import org.toqa.yaml.YamlSyntaxException;

/**
 * What a gateway is started with; {@code docs/gateway.md} explains the keys.
 *
 * @param server where it dials
 * @param data the folder for its key
 * @param robots where it may connect to
 */
record GatewayConfiguration(Server server, Path data, AllowedAddresses robots) {

  private static final int USUAL_PORT = 7276;
  private static final List<String> KEYS =
      List.of("server", "port", "fingerprint", "data", "robots");

  /**
   * @throws ConfigurationException with a sentence for people: the key, its value and what it must
   *     be
   */
  static GatewayConfiguration read(Path file) throws ConfigurationException {
    Map<?, ?> values = values(file);
    for (Object key : values.keySet()) {
      String written = String.valueOf(key);
      if (!KEYS.contains(written)) {
        throw new ConfigurationException(
            "%s: there is no key \"%s\"; ".formatted(file, written)
                + Spelling.near(written, KEYS)
                    .map("did you mean \"%s\"?"::formatted)
                    .orElseGet(() -> "there are: " + String.join(", ", KEYS)));
      }
    }
    Section section = new Section(file, values);
    return new GatewayConfiguration(
        new Server(section.host(), section.port(), section.fingerprint()),
        section.data(),
        section.robots());
  }

  private static Map<?, ?> values(Path file) throws ConfigurationException {
    try {
      if (YamlParser.parse(Files.readString(file)) instanceof Map<?, ?> map) {
        return map;
      }
      throw new ConfigurationException(file + ": this is not a list of keys and values.");
    } catch (NoSuchFileException e) {
      throw new ConfigurationException(file + ": there is no such file.");
    } catch (CharacterCodingException e) {
      throw new ConfigurationException(file + ": this is not text in UTF-8.");
    } catch (IOException e) {
      throw new ConfigurationException(file + ": cannot be read: " + e.getMessage());
    } catch (YamlSyntaxException e) {
      String line = e.line().isPresent() ? ", line " + e.line().getAsInt() : "";
      throw new ConfigurationException(file + line + ": this is not YAML: " + e.problem());
    }
  }

  /** The file's values, each checked where it is asked for. */
  private record Section(Path file, Map<?, ?> values) {

    String host() throws ConfigurationException {
      String wanted = "the server's host name or IP address";
      String host = text("server", wanted);
      if (!host.matches("[A-Za-z0-9:]([A-Za-z0-9.:%_-]{0,253}[A-Za-z0-9])?")) {
        throw invalid("server", wanted);
      }
      return host;
    }

    int port() throws ConfigurationException {
      Object port = values.get("port");
      if (port == null) {
        return USUAL_PORT;
      }
      if (port instanceof Integer number && number >= 1 && number <= 65_535) {
        return number;
      }
      throw invalid("port", "a whole number from 1 to 65535");
    }

    Fingerprint fingerprint() throws ConfigurationException {
      String wanted = "the 64 hexadecimal digits that the server's log says when it is started";
      Optional<Fingerprint> parsed = Fingerprint.parse(text("fingerprint", wanted));
      if (parsed.isEmpty()) {
        throw invalid("fingerprint", wanted);
      }
      return parsed.get();
    }

    Path data() throws ConfigurationException {
      String wanted = "a folder";
      try {
        return file.toAbsolutePath().resolveSibling(text("data", wanted)).normalize();
      } catch (InvalidPathException e) {
        throw invalid("data", wanted);
      }
    }

    AllowedAddresses robots() throws ConfigurationException {
      String wanted =
          "a list of addresses of robots, each a host name, an IP address or a block of them such"
              + " as 192.168.7.0/24, with :PORT where it is not 7275";
      if (!(values.get("robots") instanceof List<?> list)
          || list.isEmpty()
          || !list.stream().allMatch(String.class::isInstance)) {
        throw invalid("robots", wanted);
      }
      try {
        return AllowedAddresses.of(list.stream().map(String.class::cast).toList());
      } catch (IllegalArgumentException e) {
        throw new ConfigurationException(
            "%s: \"robots\" has %s; it must be %s.".formatted(file, e.getMessage(), wanted));
      }
    }

    private String text(String key, String wanted) throws ConfigurationException {
      if (values.get(key) instanceof String text && !text.isBlank()) {
        return text.strip();
      }
      throw invalid(key, wanted);
    }

    private ConfigurationException invalid(String key, String wanted) {
      @Nullable Object value = values.get(key);
      return new ConfigurationException(
          value == null
              ? "%s: the key \"%s\" is missing; it must be %s.".formatted(file, key, wanted)
              : "%s: \"%s\" is %s; it must be %s.".formatted(file, key, value, wanted));
    }
  }
}
