package org.toqa.app.config;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.allocation.Policy;
import org.toqa.network.DhcpSettings;
import org.toqa.network.Subnet;

class ConfigurationTest {
  private static final Path SHIPPED_MAP = Path.of("/webapp/WEB-INF/maps/lab.yaml");

  @TempDir private Path folder;

  @Test
  void withoutAnyLayerTheDefaultsHold() throws Exception {
    Configuration configuration = Configuration.of(SHIPPED_MAP, List.of());

    assertEquals(8080, configuration.port());
    assertEquals("127.0.0.1", configuration.address().getHostAddress());
    assertEquals(List.of(Path.of("/webapp/WEB-INF/maps/lab.yaml")), configuration.maps());
    assertEquals(Policy.OPTIMAL, configuration.allocationPolicy());
    assertEquals(List.of(0), configuration.simulatedRobots());
    assertEquals(300, configuration.requestsPerSecond());
    assertNull(configuration.firstManager());
  }

  @Test
  void theDefaultDatabaseIsAFileAmongTheData() throws Exception {
    assertEquals(
        "jdbc:h2:file:" + Path.of("toqa-data/toqa").toAbsolutePath(),
        Configuration.of(SHIPPED_MAP, List.of()).database().url());
  }

  @Test
  void theCommandLineComesBeforeTheEnvironmentAndThatBeforeTheFile() throws Exception {
    SettingSource file = file("port: 1\nsimulate: 2\nspeed: 3");
    SettingSource environment =
        SettingSource.fromEnvironment(Map.of("TOQA_PORT", "11", "TOQA_SIMULATE", "12"));
    SettingSource commandLine = commandLine(Setting.PORT, "21");

    Configuration configuration =
        Configuration.of(SHIPPED_MAP, List.of(commandLine, environment, file));

    assertEquals(21, configuration.port());
    assertEquals(List.of(12), configuration.simulatedRobots());
    assertEquals(3, configuration.simulationSpeed());
  }

  @Test
  void aGroupOfTheFileIsReadByItsKeys() throws Exception {
    Configuration configuration =
        Configuration.of(
            SHIPPED_MAP,
            List.of(
                file(
                    """
                    database:
                      url: jdbc:mysql://localhost/toqa
                      user: toqa
                      password: "123"
                    """)));

    assertEquals("jdbc:mysql://localhost/toqa", configuration.database().url());
    assertEquals("123", configuration.database().password());
  }

  @Test
  void aPathInTheFileCountsFromTheFilesFolder() throws Exception {
    assertEquals(
        folder.resolve("kept"), Configuration.of(SHIPPED_MAP, List.of(file("data: kept"))).data());
  }

  @Test
  void theFirstManagerIsSplitAtTheFirstColon() throws Exception {
    SettingSource environment =
        SettingSource.fromEnvironment(Map.of("TOQA_MANAGER", "mia:long:enough"));

    Configuration configuration = Configuration.of(SHIPPED_MAP, List.of(environment));

    assertEquals(
        new Configuration.FirstManager("mia", "long:enough"), configuration.firstManager());
  }

  @Test
  void theAllocatorIsChosenByItsWord() throws Exception {
    SettingSource environment =
        SettingSource.fromEnvironment(Map.of("TOQA_ALLOCATOR", "contract-net"));

    assertEquals(
        Policy.CONTRACT_NET,
        Configuration.of(SHIPPED_MAP, List.of(environment)).allocationPolicy());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "ALLOCATOR     | fastest        | zones, contract-net or optimal",
        "PORT          | 70000          | a whole number from 0 to 65535",
        "PORT          | 80.5           | a whole number from 0 to 65535",
        "PORT          | -1             | a whole number from 0 to 65535",
        "PORT          | 99999999999    | a whole number from 0 to 65535",
        "REQUESTS_PER_SECOND | 100001   | from 0 to 100000; 0 sets no limit",
        "REQUESTS_AT_ONCE | 0           | from 1 to 100000",
        "CHECKS_PER_USER | 0            | from 1 to 10000",
        "STREAMS_PER_USER | 0           | from 1 to 100000",
        "STREAMS_PER_ADDRESS | many     | from 1 to 100000",
        "CONNECTIONS   | 15             | from 16 to 100000",
        "CONNECTIONS_PER_ADDRESS | 3    | from 4 to 100000",
        "REQUEST_SECONDS | 0            | seconds from 1 to 3600",
        "SESSIONS_PER_USER | 0          | from 1 to 10000",
        "ADDRESS       | no such host   | a host name or IP address",
        "ADDRESS       | 203.0.113.7    | a host name or IP address of this machine",
        "MQTT_ADDRESS  | 203.0.113.7    | a host name or IP address of this machine",
        "DATA          | ''             | a folder",
        "DATA          | pom.xml        | it must be a folder",
        "MAP           | floor.bmp      | .yaml (ROS map_server) or .map",
        "MAP           | nowhere.yaml   | there is no such file",
        "DATABASE_URL  | localhost      | jdbc:mysql: or jdbc:h2:",
        "SIMULATE      | 501            | from 0 to 500",
        "WIDEST_ROBOT  | 11             | metres from 0.1 to 10",
        "MARGINS_ROBOT | -0.1           | metres from 0 to 1",
        "MARGINS_FORMATION | 0          | metres from 0.005 to 1",
        "CHARGING_BELOW| 4              | from 5 to 90",
        "CHARGING_UNTIL| 20             | more than charging.below, which is 20",
        "CHARGING_AFTER_HOURS | 25      | from 0.1 to 24",
        "CHARGING_MINUTES | soon        | from 1 to 1440",
        "SIMULATE_BATTERIES | 100,3     | percent from 5 to 100",
        "SIMULATE_AVOIDANCE | potential | weighted-directions or four-agents",
        "SIMULATE_AVOIDANCE | four-agents | set simulate as well",
        "SPEED         | NaN            | from 0.1 to 100",
        "SPEED         | 1e9            | from 0.1 to 100",
        "SPEED         | fast           | from 0.1 to 100",
        "SPEED         | 2              | set simulate as well",
        "GATEWAYS_TRUSTED | dock=9f86  | names of gateways with their fingerprints",
        "GATEWAYS_PORT | 70000         | a whole number from 0 to 65535",
        "MQTT_BROKER   | http://broker  | embedded, or the address of a broker",
        "MQTT_BROKER   | mqtt://:1      | embedded, or the address of a broker",
        "MQTT_BROKER   | mqtt://192.0.2.1 | use mqtts://, or set mqtt.plain to true",
        "MQTT_PORT     | 70000          | a whole number from 0 to 65535",
        "DHCP_SERVER   | kea            | none or dnsmasq",
        "LOG_FORMAT    | xml            | text or json",
        "LOG_LEVEL     | loud           | ERROR, WARN, INFO, DEBUG, TRACE",
      })
  void aValueThatCannotBeIsNamedWithWhatItMayBe(Setting setting, String value, String allowed) {
    String sentence = complaint(commandLine(setting, value));

    assertContains(setting.commandLineOption() + " \"" + value + "\"", sentence);
    assertContains(allowed, sentence);
  }

  @Test
  void dnsmasqNeedsItsSubnetAndAFileThatTheServerMayWrite() throws Exception {
    assertNull(Configuration.of(SHIPPED_MAP, List.of()).dhcp());
    Map<Setting, String> options = new EnumMap<>(Setting.class);
    options.put(Setting.DHCP_SERVER, "dnsmasq");
    assertContains("such as 10.0.7.0/24", complaint(SettingSource.fromCommandLine(options)));
    options.put(Setting.DHCP_SUBNET, "10.0.7.0/24");
    options.put(Setting.DHCP_HOSTS, folder.resolve("nowhere/hosts").toString());
    assertContains("may write to", complaint(SettingSource.fromCommandLine(options)));
    options.put(Setting.DHCP_HOSTS, folder.resolve("hosts").toString());

    assertEquals(
        new DhcpSettings(
            Subnet.parse("10.0.7.0/24").orElseThrow(),
            folder.resolve("hosts").toAbsolutePath(),
            Path.of("/var/lib/misc/dnsmasq.leases"),
            null),
        Configuration.of(SHIPPED_MAP, List.of(SettingSource.fromCommandLine(options))).dhcp());
  }

  @ParameterizedTest
  @CsvSource({"mia", ":secret", "mia:", "mia:$argon2id$v=19$secret"})
  void aManagerThatNobodyCanBeIsRefusedAndNotRepeated(String value) {
    String sentence = complaint(commandLine(Setting.MANAGER, value));

    assertContains("name:password", sentence);
    assertFalse(sentence.contains("secret"), sentence);
  }

  @ParameterizedTest
  @CsvSource({"mia:a", "mia:password123", "mia-the-first:mia-the-first"})
  void aManagersPasswordThatIsGuessedFirstIsRefused(String value) {
    assertContains("guessed first", complaint(commandLine(Setting.MANAGER, value)));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "prot: 80                | the key prot is unknown; the nearest is port",
        "database.uri: x         | the key database.uri is unknown; the nearest is database.url",
        "port: [1, 2]            | port needs one value",
        "port:                   | port needs one value",
        "port                    | \"key: value\"",
        "'port: 1\nport: 2'      | port is there twice",
        "'a: &a [x]\nb: [*a, *a]'| is no YAML",
        "'port: \"1'             | line 1",
        "'\u0000'                | is no YAML",
        "'!!java.net.URL [x]: 1' | only texts, numbers",
      })
  void aFileThatCannotBeReadIsNamedWithThePlace(String text, String expected) throws IOException {
    Files.writeString(folder.resolve("toqa.yaml"), text);

    String sentence =
        assertThrows(
                ConfigurationException.class,
                () -> SettingSource.fromFile(folder.resolve("toqa.yaml")))
            .getMessage();

    assertContains("toqa.yaml", sentence);
    assertContains(expected, sentence);
    assertEquals(1, sentence.lines().count(), sentence);
  }

  @ParameterizedTest
  @CsvSource({"'mail: {host: m}', mail.from", "'mail: {host: m, from: a@b.org}', url"})
  void whatAMailServerNeedsIsNamedWithTheFile(String text, String missing) throws Exception {
    String sentence = complaint(file(text));

    assertContains("mail.host in " + folder.resolve("toqa.yaml"), sentence);
    assertContains(": " + missing + " must be ", sentence);
  }

  @Test
  void aFileThatIsNotThereIsNamed() {
    Path nowhere = folder.resolve("nowhere.yaml");

    assertContains(
        nowhere + ": there is no such file",
        assertThrows(ConfigurationException.class, () -> SettingSource.fromFile(nowhere))
            .getMessage());
  }

  @Test
  void aSlipInAVariableIsNamedAndAForeignVariableIsLeftAlone() throws Exception {
    SettingSource.fromEnvironment(Map.of("TOQA_SERVICE_HOST", "10.0.0.1", "PORT", "x"));

    assertContains(
        "do you mean TOQA_PORT?",
        assertThrows(
                ConfigurationException.class,
                () -> SettingSource.fromEnvironment(Map.of("TOQA_PROT", "80")))
            .getMessage());
  }

  @Test
  void everySettingIsExplained() throws IOException {
    String page = Files.readString(Path.of("docs/configuration.md"));

    for (Setting setting : Setting.values()) {
      assertContains("| `" + setting.key() + "` |", page);
      assertContains("`" + setting.environmentVariable() + "`", page);
    }
  }

  private String complaint(SettingSource layer) {
    return assertThrows(
            ConfigurationException.class, () -> Configuration.of(SHIPPED_MAP, List.of(layer)))
        .getMessage();
  }

  private SettingSource file(String text) throws Exception {
    return SettingSource.fromFile(Files.writeString(folder.resolve("toqa.yaml"), text));
  }

  private static SettingSource commandLine(Setting setting, String value) {
    Map<Setting, @Nullable String> options = new EnumMap<>(Setting.class);
    options.put(setting, value);
    return SettingSource.fromCommandLine(options);
  }

  private static void assertContains(String part, String whole) {
    if (!whole.contains(part)) {
      throw new AssertionError("expected \"" + part + "\" in: " + whole);
    }
  }
}
