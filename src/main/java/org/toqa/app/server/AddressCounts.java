package org.toqa.app.server;

import java.util.HashMap;
import java.util.Map;
import java.util.stream.Stream;

/**
 * How many connections each address has at most, so that not all of them are looked at when one
 * comes. Those that ended are counted until all are counted anew. For one thread.
 */
final class AddressCounts {
  private Map<String, Integer> counts = new HashMap<>();

  /** Counts a new one, and answers how many that address has now at most. */
  int add(String address) {
    return counts.merge(address, 1, Integer::sum);
  }

  /** Counts anew. */
  void set(Stream<String> addresses) {
    Map<String, Integer> next = new HashMap<>();
    addresses.forEach(address -> next.merge(address, 1, Integer::sum));
    counts = next;
  }
}
