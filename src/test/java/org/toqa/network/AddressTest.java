package org.toqa.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Addresses as people type them, and as files have them. */
class AddressTest {

  @Property
  void everyIpAddressIsReadAsItIsWritten(@ForAll int bits) {
    Ipv4Address address = new Ipv4Address(bits);

    assertEquals(Optional.of(address), Ipv4Address.parse(address.toString()));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "10.0.7",
        "10.0.7.256",
        "10.0.7.020",
        "1",
        "::1",
        "10.0.7.20 ",
        "10.0.7.-1",
        "a.b.c.d"
      })
  void whatIsNoIpAddressIsRefused(String text) {
    assertEquals(Optional.empty(), Ipv4Address.parse(text));
  }

  @Test
  void hardwareAddressHasOneText() {
    HardwareAddress address = new HardwareAddress("02:00:5e:10:00:0a");

    assertEquals(Optional.of(address), HardwareAddress.parse("02-00-5E-10-00-0A"));
    assertEquals(Optional.of(address), HardwareAddress.parse(address.toString()));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "02:00:5e:10:00",
        "02:00:5e:10:00:0g",
        "01:00:5e:10:00:0a", // of a group
        "ff:ff:ff:ff:ff:ff",
        "00:00:00:00:00:00",
        "02:00:5e:10:00:0a,ignore",
        "02:00:5e:10:00:0a\n02:00:5e:10:00:0b"
      })
  void whatIsNoHardwareAddressOfOneDeviceIsRefused(String text) {
    assertEquals(Optional.empty(), HardwareAddress.parse(text));
  }

  @Property
  void subnetHasItsAddressesAndNoOthers(
      @ForAll int bits, @ForAll @IntRange(min = 8, max = 30) int length, @ForAll int other) {
    int mask = -1 << (32 - length);
    Subnet subnet = Subnet.parse(new Ipv4Address(bits & mask) + "/" + length).orElseThrow();
    int within = (bits & mask) | (other & ~mask);
    boolean isEdge = (within & ~mask) == 0 || (within & ~mask) == ~mask;

    assertEquals(!isEdge, subnet.isForDevice(new Ipv4Address(within)));
    assertFalse(subnet.isForDevice(new Ipv4Address(within ^ 1 << (32 - length))));
  }

  @Test
  void subnetBeginsWithItsFirstAddress() {
    assertTrue(Subnet.parse("10.0.7.0/24").isPresent());
    assertEquals(Optional.empty(), Subnet.parse("10.0.7.1/24"));
    assertEquals(Optional.empty(), Subnet.parse("10.0.7.0/31"));
    assertEquals(Optional.empty(), Subnet.parse("10.0.7.0"));
  }
}
