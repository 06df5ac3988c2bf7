package org.toqa.network;

import java.io.IOException;
import java.net.ConnectException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.time.Duration;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/**
 * Asks devices whether they are there, without rights that a server should not have: by a
 * connection to their web page. Who takes it is there, and so is who refuses it; who drops it
 * without a word, as behind a firewall, is there if he answered for his address (ARP).
 */
final class Prober {
  private static final int PORT = 80;
  private static final Duration LIMIT = Duration.ofSeconds(1);

  private Prober() {}

  /** Those that are there; asked all at once. */
  static Set<Ipv4Address> reachable(Set<Ipv4Address> addresses) throws InterruptedException {
    Map<Ipv4Address, Future<Boolean>> asked = new HashMap<>();
    try (ExecutorService threads = Executors.newVirtualThreadPerTaskExecutor()) {
      for (Ipv4Address address : addresses) {
        asked.put(address, threads.submit(() -> answers(address)));
      }
      Map<Ipv4Address, Boolean> answers = new HashMap<>();
      for (Map.Entry<Ipv4Address, Future<Boolean>> question : asked.entrySet()) {
        answers.put(question.getKey(), answer(question.getValue()));
      }
      Set<Ipv4Address> there = new HashSet<>();
      Map<Ipv4Address, HardwareAddress> neighbours = NeighbourTable.read();
      answers.forEach(
          (address, answered) -> {
            if (answered || neighbours.containsKey(address)) {
              there.add(address);
            }
          });
      return there;
    }
  }

  private static boolean answer(Future<Boolean> future) throws InterruptedException {
    try {
      return future.get();
    } catch (ExecutionException e) {
      return false;
    }
  }

  private static boolean answers(Ipv4Address address) {
    try (Socket socket = new Socket()) {
      socket.connect(
          new InetSocketAddress(address.toInetAddress(), PORT), Math.toIntExact(LIMIT.toMillis()));
      return true;
    } catch (ConnectException e) {
      return String.valueOf(e.getMessage()).contains("refused");
    } catch (IOException e) {
      return false;
    }
  }
}
