package org.toqa.agent.routing;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.toqa.link.message.AgentMessage.NetworkRoute;

class RouteTableTest {

  /** What babeld 1.12.1 said of a node at the end of a chain that has just become longer. */
  private static final List<String> DUMP =
      """
      add interface wlan0 up true ipv6 fe80::4 ipv4 10.77.0.4
      add neighbour 559cfa5f4630 address fe80::3 if wlan0 reach ff80 ureach 0000 rxcost 256 txcost 256 cost 256
      add neighbour 559cfa5f3d60 address fe80::1 if wlan0 reach 0003 ureach 0000 rxcost 65535 txcost 65535 cost 65535
      add xroute 10.77.0.4/32-0.0.0.0/0 prefix 10.77.0.4/32 from 0.0.0.0/0 metric 0
      add route 559cfa5f4a20 prefix 10.77.0.1/32 from 0.0.0.0/0 installed yes id bc:05:cf:8e:cf:5c:9f:75 metric 768 refmetric 512 via fe80::3 if wlan0
      add route 559cfa5f4960 prefix 10.77.0.1/32 from 0.0.0.0/0 installed no id bc:05:cf:8e:cf:5c:9f:75 metric 65535 refmetric 0 via fe80::1 if wlan0
      add route 559cfa5f4b60 prefix 10.77.0.3/32 from 0.0.0.0/0 installed yes id 38:da:02:70:c1:3a:c1:3d metric 256 refmetric 0 via fe80::3 if wlan0
      add route 559cfa5f2420 prefix 10.77.0.3/32 from 0.0.0.0/0 installed no id 38:da:02:70:c1:3a:c1:3d metric 65535 refmetric 256 via fe80::1 if wlan0
      """
          .lines()
          .toList();

  private static Optional<NetworkRoute> route(List<String> dump, String to)
      throws UnknownHostException {
    return RouteTable.parse(dump).routeTo(InetAddress.getByName(to));
  }

  @Test
  void nextHopIsKnownByTheAddressThatItAnnounces() throws Exception {
    assertEquals(
        Optional.of(new NetworkRoute("10.77.0.3", 768, 9 / 16.0)), // ff80: nine of sixteen
        route(DUMP, "10.77.0.1"));
  }

  @Test
  void whoIsHeardItselfIsTheNextHop() throws Exception {
    assertEquals("10.77.0.3", route(DUMP, "10.77.0.3").orElseThrow().nextHop());
  }

  @Test
  void baseStationBeforeTheServerIsToldByItsOwnAddress() throws Exception {
    List<String> dump =
        """
        add neighbour 1 address fe80::1 if wlan0 reach ffff ureach 0000 rxcost 256 txcost 256 cost 256
        add route 2 prefix 10.9.0.1/32 from 0.0.0.0/0 installed yes id 0 metric 256 refmetric 0 via fe80::1 if wlan0
        add route 3 prefix 10.77.0.1/32 from 0.0.0.0/0 installed yes id 0 metric 256 refmetric 0 via fe80::1 if wlan0
        """
            .lines()
            .toList();

    assertEquals(Optional.of(new NetworkRoute("10.77.0.1", 256, 1)), route(dump, "10.9.0.1"));
  }

  @Test
  void routeThatIsNotUsedOrInfinitelyLongIsNone() throws Exception {
    assertEquals(Optional.empty(), route(DUMP, "10.77.0.2"));
    List<String> retracted =
        DUMP.stream().map(line -> line.replace("metric 768", "metric 65535")).toList();
    assertEquals(Optional.empty(), route(retracted, "10.77.0.1"));
  }

  @Test
  void linesOfAnotherReleaseAreLeftOut() throws Exception {
    List<String> odd = List.of("add route 1 prefix", "add neighbour", "", "add route 1 metric x");

    assertEquals(RouteTable.EMPTY, RouteTable.parse(odd));
  }
}
