package org.toqa.network;

import java.io.IOException;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.network.DeviceAnswer.Reason;
import org.toqa.network.DeviceAnswer.Refusal;
import org.toqa.persistence.StoreException;

/**
 * The devices of a site: what is known of them, and what managers say of them. Any thread may call
 * it. One thread of its own tells the DHCP server and asks who is there.
 */
public final class Network implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(Network.class);

  /** Of a site. */
  public static final int MOST_DEVICES = 500;

  private static final Duration PERIOD = Duration.ofSeconds(10);
  private static final Duration ANSWER_LIMIT = Duration.ofSeconds(5);

  private final DeviceStore store;
  private final @Nullable Dnsmasq dhcp;
  private final InstantSource clock;
  private final ScheduledExecutorService worker;

  /** Written by the worker. */
  private volatile Map<Ipv4Address, Contact> contacts = Map.of();

  /** Why the DHCP server was not told; written by the worker. */
  private volatile Optional<DhcpTrouble> trouble = Optional.empty();

  /**
   * @param settings null: this server configures no DHCP server, and asks none
   */
  public Network(DeviceStore store, @Nullable DhcpSettings settings, InstantSource clock) {
    this.store = store;
    this.dhcp = settings == null ? null : new Dnsmasq(settings);
    this.clock = clock;
    this.worker =
        Executors.newSingleThreadScheduledExecutor(
            Thread.ofPlatform().daemon().name("network").factory());
  }

  /** From now on the DHCP server is told, and devices are asked whether they are there. */
  public void start() {
    var _ =
        worker.scheduleWithFixedDelay(this::refresh, 0, PERIOD.toMillis(), TimeUnit.MILLISECONDS);
  }

  /** An error is one that the next time may not have. */
  void refresh() {
    try {
      publish();
      ask();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (StoreException e) {
      log.debug("The devices are not known now.", e); // the fleet tells that its database is away
    } catch (RuntimeException e) {
      log.warn("The devices of the network could not be asked; it is tried again.", e);
    }
  }

  private void publish() {
    if (dhcp == null) {
      return;
    }
    Optional<DhcpTrouble> now = dhcp.publish(store.devices());
    if (now.isPresent() && !now.equals(trouble)) {
      log.warn("The DHCP server was not told of its reservations: {}", now.get());
    }
    trouble = now;
  }

  private void ask() throws InterruptedException {
    NetworkList list = new NetworkList(List.of(), store.devices(), leases(), Map.of(), Map.of());
    Set<Ipv4Address> addresses = list.toAsk();
    Set<Ipv4Address> there = Prober.reachable(addresses);
    Instant now = clock.instant();
    Map<Ipv4Address, Contact> before = contacts;
    Map<Ipv4Address, Contact> next = new HashMap<>();
    for (Ipv4Address address : addresses) {
      Contact last = before.get(address);
      next.put(
          address,
          there.contains(address)
              ? new Contact(true, now)
              : new Contact(false, last == null ? null : last.heardAt()));
    }
    contacts = Map.copyOf(next);
  }

  /** The subnet that the DHCP server serves; empty: none is configured. */
  public Optional<Subnet> subnet() {
    return Optional.ofNullable(dhcp).map(Dnsmasq::subnet);
  }

  /** What keeps it from being told and read; empty: nothing, or none is configured. */
  public Optional<DhcpTrouble> trouble() {
    if (dhcp == null || trouble.isPresent()) {
      return trouble;
    }
    try {
      dhcp.leases(clock.instant());
      return Optional.empty();
    } catch (IOException e) {
      return Optional.of(
          new DhcpTrouble(DhcpTrouble.Kind.LEASES_NOT_READ, dhcp.leaseFile().toString()));
    }
  }

  private List<Lease> leases() {
    try {
      return dhcp == null ? List.of() : dhcp.leases(clock.instant());
    } catch (IOException e) {
      return List.of(); // trouble() says so
    }
  }

  /** All that are known: robots, other devices, and who has a lease besides. */
  public List<NetworkEntry> entries(List<KnownRobot> robots) {
    return new NetworkList(robots, store.devices(), leases(), NeighbourTable.read(), contacts)
        .entries();
  }

  public Optional<Device> device(long id) {
    return store.devices().stream().filter(device -> device.id() == id).findFirst();
  }

  /**
   * @param robots of the fleet
   * @param by a user's name
   */
  public DeviceAnswer add(DeviceOrder order, List<KnownRobot> robots, String by) {
    List<Device> devices = store.devices();
    List<Refusal> refusals = refusals(order, devices, robots);
    if (devices.size() >= MOST_DEVICES) {
      refusals.add(new Refusal(Reason.TOO_MANY, String.valueOf(MOST_DEVICES)));
    }
    if (!refusals.isEmpty()) {
      return new DeviceAnswer.Refused(refusals);
    }
    Device added = store.add(order, by);
    publishNow();
    return new DeviceAnswer.Stored(added);
  }

  /** The same for a device that is there. */
  public DeviceAnswer change(long id, DeviceOrder order, List<KnownRobot> robots, String by) {
    List<Device> others = store.devices().stream().filter(device -> device.id() != id).toList();
    List<Refusal> refusals = refusals(order, others, robots);
    if (!refusals.isEmpty()) {
      return new DeviceAnswer.Refused(refusals);
    }
    if (!store.change(id, order, by)) {
      return new DeviceAnswer.Unknown();
    }
    publishNow();
    return new DeviceAnswer.Stored(new Device(id, order));
  }

  /**
   * @return false: there is no such device
   */
  public boolean delete(long id, String by) {
    boolean isDone = store.delete(id, by);
    if (isDone) {
      publishNow();
    }
    return isDone;
  }

  private List<Refusal> refusals(DeviceOrder order, List<Device> others, List<KnownRobot> robots) {
    List<Refusal> refusals =
        new ArrayList<>(
            new DeviceRules(others, robots, leases(), dhcp == null ? null : dhcp.subnet())
                .refusals(order));
    if (order.address() != null && isOfThisMachine(order.address())) {
      refusals.add(new Refusal(Reason.ADDRESS_OF_SERVER, order.address().toString()));
    }
    return refusals;
  }

  private static boolean isOfThisMachine(Ipv4Address address) {
    try {
      return NetworkInterface.getByInetAddress(address.toInetAddress()) != null;
    } catch (SocketException e) {
      return false;
    }
  }

  /** Waits until the DHCP server is told, so that {@link #trouble} knows; for a while only. */
  private void publishNow() {
    if (dhcp == null) {
      return;
    }
    try {
      worker.submit(this::publish).get(ANSWER_LIMIT.toMillis(), TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (ExecutionException | TimeoutException e) {
      log.warn("The DHCP server is told of its reservations later.", e);
    }
  }

  @Override
  public void close() {
    worker.shutdown();
    try {
      if (!worker.awaitTermination(ANSWER_LIMIT.toMillis(), TimeUnit.MILLISECONDS)) {
        log.warn("The network is still being asked.");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
