package org.toqa.link.gateway;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.net.UnknownHostException;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class AllowedAddressesTest {

  @ParameterizedTest
  @CsvSource({
    "192.168.7.0/24,      192.168.7.255, 7275, true",
    "192.168.7.0/24,      192.168.8.1,   7275, false",
    "192.168.7.0/24,      192.168.7.1,   22,   false",
    "192.168.7.0/24:7300, 192.168.7.1,   7300, true",
    "192.168.7.0/24:7300, 192.168.7.1,   7275, false",
    "192.168.7.0/25,      192.168.7.128, 7275, false",
    "192.168.7.9,         192.168.7.9,   7275, true",
    "192.168.7.9,         192.168.7.8,   7275, false",
    "0.0.0.0/0,           8.8.8.8,       7275, true",
    "0.0.0.0/0,           ::1,           7275, false",
    "fd00::/64,           fd00::7,       7275, true",
    "fd00::/64,           fd00:0:0:1::7, 7275, false",
    "[fd00::7]:80,        fd00::7,       80,   true",
    "localhost,           LocalHost,     7275, true",
    "localhost,           127.0.0.1,     7275, false",
    "127.0.0.0/8:1,       localhost,     1,    true",
  })
  void whatIsNamedIsAllowedAndNothingElse(String rule, String host, int port, boolean isAllowed)
      throws UnknownHostException {
    assertEquals(isAllowed, AllowedAddresses.of(List.of(rule)).find(host, port).isPresent());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "192.168.7.0/33",
        "192.168.7.0/-1",
        "192.168.7.0/24/8",
        "192.168.7",
        "192.168.7.256",
        "robot:0",
        "robot:65536",
        "robot:x",
        "robot one",
        "fd00::/129",
        "http://robot",
      })
  void whatIsNoAddressIsRefused(String text) {
    assertThrows(IllegalArgumentException.class, () -> AllowedAddresses.of(List.of(text)));
  }
}
