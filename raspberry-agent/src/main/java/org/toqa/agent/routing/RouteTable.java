package org.toqa.agent.routing;

import java.net.InetAddress;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.toqa.link.message.AgentMessage.NetworkRoute;

/**
 * What babeld knows at one instant, as its local interface tells it in answer to {@code dump}
 * (babeld(8), protocol 1.0): lines of a word, a kind, an identifier, and names with their values.
 *
 * @param neighbours whom it hears itself
 * @param routes all that it knows, whether they are used or not
 */
record RouteTable(List<Neighbour> neighbours, List<Route> routes) {

  static final RouteTable EMPTY = new RouteTable(List.of(), List.of());

  /** A metric that means: not reached (RFC 8966, section 3.5.2). */
  private static final int INFINITY = 65_535;

  /** So many greetings are remembered: bits of {@code reach}. */
  private static final int REMEMBERED = 16;

  private static final int BEFORE_VALUES = 3;

  /**
   * @param address on the link, IPv6
   * @param reach which of its last 16 greetings were heard, a bit each
   */
  record Neighbour(String address, String link, int reach) {
    double quality() {
      return (double) Integer.bitCount(reach) / REMEMBERED;
    }
  }

  /**
   * @param prefix whither, such as {@code 10.0.9.11/32}
   * @param isUsed whether packets go this way
   * @param rest the metric from the next hop on; 0: that has announced it itself
   * @param via the next hop's address on the link
   */
  record Route(String prefix, boolean isUsed, int metric, int rest, String via, String link) {}

  RouteTable {
    neighbours = List.copyOf(neighbours);
    routes = List.copyOf(routes);
  }

  /** Reads what is understood, and leaves out the rest. */
  static RouteTable parse(List<String> lines) {
    List<Neighbour> neighbours = new ArrayList<>();
    List<Route> routes = new ArrayList<>();
    for (String line : lines) {
      Map<String, String> values = values(line);
      try {
        if (line.startsWith("add neighbour ")) {
          neighbours.add(
              new Neighbour(
                  values.getOrDefault("address", ""),
                  values.getOrDefault("if", ""),
                  Integer.parseInt(values.getOrDefault("reach", ""), 16) & 0xffff));
        } else if (line.startsWith("add route ")) {
          routes.add(
              new Route(
                  values.getOrDefault("prefix", ""),
                  "yes".equals(values.get("installed")),
                  Integer.parseInt(values.getOrDefault("metric", "")),
                  Integer.parseInt(values.getOrDefault("refmetric", "")),
                  values.getOrDefault("via", ""),
                  values.getOrDefault("if", "")));
        }
      } catch (NumberFormatException e) {
        // of a babeld that writes otherwise
      }
    }
    return new RouteTable(neighbours, routes);
  }

  private static Map<String, String> values(String line) {
    String[] words = line.split(" ", -1);
    Map<String, String> values = new HashMap<>();
    for (int i = BEFORE_VALUES; i + 1 < words.length; i += 2) {
      values.put(words[i], words[i + 1]);
    }
    return values;
  }

  /** The route that packets to that address take; empty: there is none. */
  Optional<NetworkRoute> routeTo(InetAddress destination) {
    String prefix = destination.getHostAddress() + "/32";
    return routes.stream()
        .filter(route -> route.isUsed() && route.metric() < INFINITY)
        .filter(route -> route.prefix().equals(prefix))
        .min(Comparator.comparingInt(Route::metric))
        .map(route -> new NetworkRoute(nextHop(route), route.metric(), quality(route)));
  }

  /**
   * The address that the next hop has in the network. Where that announces the route itself it may
   * be a base station that stands before the destination: it is told by its own address then.
   */
  private String nextHop(Route route) {
    return routes.stream()
        .filter(other -> other.rest() == 0 && isVia(route, other))
        .map(Route::prefix)
        .filter(prefix -> prefix.endsWith("/32"))
        .min(Comparator.comparing((String prefix) -> prefix.equals(route.prefix())))
        .map(prefix -> prefix.substring(0, prefix.indexOf('/')))
        .orElse(route.via());
  }

  private static boolean isVia(Route one, Route other) {
    return one.via().equals(other.via()) && one.link().equals(other.link());
  }

  private double quality(Route route) {
    return neighbours.stream()
        .filter(other -> other.address().equals(route.via()) && other.link().equals(route.link()))
        .findFirst()
        .map(Neighbour::quality)
        .orElse(0.0);
  }
}
