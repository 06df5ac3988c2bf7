package org.toqa.agent.access;

import java.net.InetAddress;
import java.net.Socket;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * Connections that have not shown yet whose they are, only a few at a time: beyond that the address
 * that has the most of them loses its oldest, so that one address with many does not block the
 * others.
 */
final class PendingConnections {

  static final int MAX_PENDING = 16;

  /** Oldest first. */
  private final List<Socket> pending = new ArrayList<>();

  /** Adds a connection; the one that is dropped for it, if there were too many. */
  synchronized Optional<Socket> add(Socket newcomer) {
    pending.add(newcomer);
    if (pending.size() <= MAX_PENDING) {
      return Optional.empty();
    }
    InetAddress address = mostFrequentAddress();
    Optional<Socket> oldest =
        pending.stream().filter(s -> s.getInetAddress().equals(address)).findFirst();
    oldest.ifPresent(pending::remove);
    return oldest;
  }

  synchronized void remove(Socket socket) {
    pending.remove(socket);
  }

  synchronized List<Socket> all() {
    return List.copyOf(pending);
  }

  private InetAddress mostFrequentAddress() {
    Map<InetAddress, Long> counts =
        pending.stream()
            .map(Socket::getInetAddress)
            .collect(Collectors.groupingBy(Function.identity(), Collectors.counting()));
    return counts.entrySet().stream()
        .max(Comparator.comparingLong(Map.Entry::getValue))
        .orElseThrow()
        .getKey();
  }
}
