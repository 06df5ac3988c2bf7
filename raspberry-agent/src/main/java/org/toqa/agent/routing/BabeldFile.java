package org.toqa.agent.routing;

import java.util.Locale;
import org.toqa.agent.config.AdHocNetwork;

/** The configuration of a babeld, as babeld(8) has it. */
final class BabeldFile {

  private BabeldFile() {}

  /**
   * Of a node of that network: it announces its own addresses on those interfaces and nothing else,
   * and believes routes to single addresses of IPv4 only, so that nobody in reach can draw other
   * traffic to himself. Each interface counts as wireless: who hears a node need not hear its
   * neighbours, and what is lost counts.
   */
  static String text(AdHocNetwork network) {
    StringBuilder text = new StringBuilder("# Written by the robot's daemon at its start.\n");
    text.append("random-id true\n");
    if (network.key() != null) {
      text.append("key id fleet type hmac-sha256 value ").append(network.key()).append('\n');
    }
    for (String name : network.interfaces()) {
      text.append("interface ").append(name).append(" type wireless");
      text.append(String.format(Locale.ROOT, " hello-interval %.2f", network.helloSeconds()));
      text.append(network.key() == null ? "\n" : " key fleet\n");
    }
    for (String name : network.interfaces()) {
      text.append("redistribute local ip 0.0.0.0/0 if ").append(name).append(" allow\n");
    }
    return text.append("redistribute local deny\n")
        .append("redistribute deny\n")
        .append("in ip 0.0.0.0/0 ge 32 allow\n")
        .append("in deny\n")
        .toString();
  }
}
