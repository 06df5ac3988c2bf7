package org.toqa.app.gateway;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.app.config.ConfigurationException;

class GatewayConfigurationTest {
  private static final String GOOD =
      """
      server: toqa.example.org
      fingerprint: %s
      data: kept
      robots: [192.168.7.0/24, "forklift.lab:7300"]
      """
          .formatted("a".repeat(64));

  @TempDir private Path folder;

  @Test
  void aFileIsReadWithItsDefaults() throws Exception {
    GatewayConfiguration read = read(GOOD);
    assertEquals("toqa.example.org:7276", read.server().toString());
    assertEquals("a".repeat(64), read.server().fingerprint().hex());
    assertEquals(folder.resolve("kept"), read.data());
    assertEquals(7300, read(GOOD + "port: 7300\n").server().port());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "server: toqa.example.org | server: 'http://toqa' | \"server\" is http://toqa; it must be",
        "server: toqa.example.org | # | the key \"server\" is missing",
        "data: kept | port: 0 | \"port\" is 0; it must be a whole number from 1 to 65535",
        "data: kept | port: '7276' | \"port\" is 7276; it must be a whole number",
        "data: kept | dat: kept | there is no key \"dat\"; did you mean \"data\"?",
        "fingerprint: a | fingerprint: b7 | \"fingerprint\" is",
        "192.168.7.0/24 | 192.168.7.0/33 | \"robots\" has 192.168.7.0/33; it must be a list",
        "robots: [192.168.7.0/24, | robots: # [ | \"robots\" is missing",
        "server: toqa | : | this is not YAML",
      })
  void aValueThatCannotBeIsNamedWithWhatItMayBe(String good, String bad, String sentence)
      throws IOException {
    String text = GOOD.replace(good, bad);
    ConfigurationException e = assertThrows(ConfigurationException.class, () -> read(text));
    assertTrue(e.getMessage().contains(sentence), e.getMessage());
  }

  private GatewayConfiguration read(String text) throws IOException, ConfigurationException {
    return GatewayConfiguration.read(Files.writeString(folder.resolve("gateway.yaml"), text));
  }
}
