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
 * Connections that have not shown yet who they are. There is room for a few; where it is full, the
 * address that has the most of them gives its oldest up, so that one that crowds the room does not
 * keep the others out.
 */
final class PendingConnections {

  static final int MAX_PENDING = 16;

  /** Oldest first. */
  private final List<Socket> pending = new ArrayList<>();

  /** Takes the connection in; the one that must go for it, if the room was full. */
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
