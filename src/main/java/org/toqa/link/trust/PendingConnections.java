package org.toqa.link.trust;

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
public final class PendingConnections {

  private final int limit;

  /** Oldest first. */
  private final List<Socket> pending = new ArrayList<>();

  /**
   * @param limit how many there may be at once, 1 or more
   */
  public PendingConnections(int limit) {
    this.limit = limit;
  }

  /** Adds a connection; the one that is dropped for it, if there were too many. */
  public synchronized Optional<Socket> add(Socket newcomer) {
    pending.add(newcomer);
    if (pending.size() <= limit) {
      return Optional.empty();
    }
    InetAddress address = mostFrequentAddress();
    Optional<Socket> oldest =
        pending.stream().filter(s -> s.getInetAddress().equals(address)).findFirst();
    oldest.ifPresent(pending::remove);
    return oldest;
  }

  public synchronized void remove(Socket socket) {
    pending.remove(socket);
  }

  public synchronized List<Socket> all() {
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
