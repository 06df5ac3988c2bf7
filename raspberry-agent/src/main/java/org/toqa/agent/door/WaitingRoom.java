package org.toqa.agent.door;

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
final class WaitingRoom {

  static final int MOST = 16;

  /** Oldest first. */
  private final List<Socket> waiting = new ArrayList<>();

  /** Takes the connection in; the one that must go for it, if the room was full. */
  synchronized Optional<Socket> enter(Socket newcomer) {
    waiting.add(newcomer);
    if (waiting.size() <= MOST) {
      return Optional.empty();
    }
    InetAddress crowd = largestCrowd();
    Optional<Socket> oldest =
        waiting.stream().filter(s -> s.getInetAddress().equals(crowd)).findFirst();
    oldest.ifPresent(waiting::remove);
    return oldest;
  }

  synchronized void leave(Socket socket) {
    waiting.remove(socket);
  }

  synchronized List<Socket> all() {
    return List.copyOf(waiting);
  }

  private InetAddress largestCrowd() {
    Map<InetAddress, Long> crowds =
        waiting.stream()
            .map(Socket::getInetAddress)
            .collect(Collectors.groupingBy(Function.identity(), Collectors.counting()));
    return crowds.entrySet().stream()
        .max(Comparator.comparingLong(Map.Entry::getValue))
        .orElseThrow()
        .getKey();
  }
}
