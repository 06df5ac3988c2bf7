package org.toqa.agent.door;

import java.io.IOException;
import java.security.SecureRandom;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkSocket;
import org.toqa.link.trust.LinkTls;
import org.toqa.link.trust.PairingCode;

/**
 * The way into a daemon, encrypted or not for as long as it is open: not where the robot was never
 * paired, shows no code, and may do without. A robot that may not do without and was never paired
 * shows a code by itself. While it is open an encrypted door takes new codes by {@link
 * PairingRequest}.
 *
 * <p>Any thread may call it; none waits.
 */
public final class Door implements AutoCloseable {

  private final DoorConfig config;
  private final Refusals refusals;
  private final @Nullable LinkTls tls;
  private final @Nullable GuestList guests;
  private final @Nullable PairingOffer offer;
  private final @Nullable PairingWatch watch;
  private final ServerDoor listening;

  /**
   * Opens it.
   *
   * @param taken is given each connection whose other end may speak, by a thread of the door's
   * @throws IOException with a sentence for people
   */
  public Door(DoorConfig config, Consumer<LinkSocket> taken) throws IOException {
    this.config = config;
    refusals = new Refusals(config.robot(), config.nanos());
    ServerPin pin = new ServerPin(config.folder());
    boolean paired = pin.server().isPresent();
    Threshold threshold;
    if (!paired && !config.pair() && config.mayBePlain()) {
      tls = null;
      guests = null;
      offer = null;
      watch = null;
      threshold = new PlainThreshold(taken);
    } else {
      LinkTls own = new LinkTls(IdentityFile.open(config.folder()));
      GuestList list = new GuestList(pin);
      Fingerprint robot = own.fingerprint();
      PairingOffer code = config.pair() || !paired ? newOffer(robot) : null;
      PairingDesk desk = new PairingDesk(config.robot(), list, refusals, code);
      tls = own;
      guests = list;
      offer = code;
      threshold = new TlsThreshold(own, list, desk, refusals, taken);
      watch =
          new PairingWatch(
              config.robot(),
              new PairingRequest(config.folder()),
              asked -> desk.show(new PairingOffer(asked, robot, config.nanos())));
    }
    try {
      listening = new ServerDoor(config.robot(), config.address(), config.port(), threshold);
    } catch (IOException e) {
      closeWatch();
      throw e;
    }
  }

  private PairingOffer newOffer(Fingerprint robot) {
    return new PairingOffer(PairingCode.of(robot, new SecureRandom()), robot, config.nanos());
  }

  private void closeWatch() {
    if (watch != null) {
      watch.close();
    }
  }

  public int port() {
    return listening.port();
  }

  /** Empty where the link is not encrypted. */
  public Optional<LinkTls> tls() {
    return Optional.ofNullable(tls);
  }

  /** The code that is shown from the beginning, as people read it. */
  public Optional<String> code() {
    return Optional.ofNullable(offer).map(PairingOffer::shown);
  }

  /**
   * As what a peer may speak now.
   *
   * @param peer null where the link is not encrypted
   */
  public PeerRole roleOf(@Nullable Fingerprint peer) {
    if (guests == null) {
      return PeerRole.ANYBODY;
    }
    return peer == null ? PeerRole.NOBODY : guests.roleOf(peer);
  }

  /** The server has named a leader: it may come in from now on. */
  public void expectLeader(Fingerprint leader) {
    if (guests != null) {
      guests.expectLeader(leader);
    }
  }

  /** Whom it did not let in of late. */
  public Optional<Fault> refused() {
    return refusals.fault();
  }

  @Override
  public void close() {
    closeWatch();
    listening.close();
  }

  @Override
  public String toString() {
    return "%s port %d".formatted(config.address(), port());
  }
}
