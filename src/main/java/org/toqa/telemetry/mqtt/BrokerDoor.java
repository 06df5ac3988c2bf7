package org.toqa.telemetry.mqtt;

import java.net.InetAddress;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Predicate;
import org.toqa.accounts.AddressBlock;

/**
 * The TCP connections to an embedded broker, whoever they turn out to be: so many of one address
 * and so many in all, and no more new ones in a time than an address may try, since each may ask
 * the store whose a password is. This machine's own, of which the server's are some, are not
 * counted by address, and have a few places that nobody else can take. Any thread may call it.
 */
public final class BrokerDoor {
  /** Of this machine alone: beyond those of the server's sites there is room for others. */
  static final int RESERVE = 64;

  private final int most;
  private final int mostPerAddress;
  private final Predicate<String> mayTry;
  private final Map<String, Integer> byAddress = new HashMap<>();
  private int count;

  /**
   * @param most of all addresses together
   * @param mostPerAddress addresses of one subscriber count as one
   * @param mayTry whether somebody of that address, or block of addresses, may try again now; it is
   *     counted as a try
   */
  public BrokerDoor(int most, int mostPerAddress, Predicate<String> mayTry) {
    this.most = most;
    this.mostPerAddress = mostPerAddress;
    this.mayTry = mayTry;
  }

  /**
   * Counts another connection.
   *
   * @return false: there is no place for it, or it comes too soon
   */
  boolean tryEnter(InetAddress address) {
    String block = AddressBlock.of(address.getHostAddress());
    boolean isOwn = address.isLoopbackAddress();
    return (isOwn || mayTry.test(block)) && tryEnter(block, isOwn);
  }

  private synchronized boolean tryEnter(String block, boolean isOwn) {
    int ofAddress = byAddress.getOrDefault(block, 0);
    if (count >= (isOwn ? most + RESERVE : most) || (!isOwn && ofAddress >= mostPerAddress)) {
      return false;
    }
    byAddress.put(block, ofAddress + 1);
    count++;
    return true;
  }

  /** One that was counted has ended. */
  synchronized void leave(InetAddress address) {
    byAddress.computeIfPresent(
        AddressBlock.of(address.getHostAddress()), (_, n) -> n == 1 ? null : n - 1);
    count--;
  }
}
