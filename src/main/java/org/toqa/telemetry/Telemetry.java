package org.toqa.telemetry;

import com.github.benmanes.caffeine.cache.Cache;
import com.github.benmanes.caffeine.cache.Caffeine;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Predicate;
import org.toqa.accounts.Secret;
import org.toqa.telemetry.ReadingBoard.RobotReadings;
import org.toqa.wording.Sentence;

/**
 * What a site's robots measure, for those who show it, with its limits; and the passwords by which
 * they publish it. Any thread may call it.
 */
public final class Telemetry {
  /** After which a reading that is not renewed is no alert any more. */
  static final Duration FRESH = Duration.ofMinutes(1);

  /** After which it is noticed that a robot was removed, and its password with it. */
  private static final Duration KNOWN_FOR = Duration.ofSeconds(5);

  private static final int MAX_KNOWN = 10_000;

  private final String site;
  private final ReadingBoard board;
  private final Predicate<String> isRobot;
  private final TelemetryStore store;
  private final InstantSource clock;
  private final BrokerPlace broker;

  /** As stored. */
  private volatile List<ReadingLimits> limits;

  private final Cache<String, Optional<String>> hashes =
      Caffeine.newBuilder()
          .maximumSize(MAX_KNOWN)
          .expireAfterWrite(KNOWN_FOR)
          .executor(Runnable::run)
          .build();

  /**
   * Where programs find the broker.
   *
   * @param address as a URL, {@code mqtt://} or {@code mqtts://}
   * @param isEmbedded whether it takes the passwords that are made here
   */
  public record BrokerPlace(String address, boolean isEmbedded) {}

  /** What a robot publishes by. */
  public record Login(String user, String password) {
    /** Without the password, so that it reaches no log. */
    @Override
    public String toString() {
      return "Login[" + user + "]";
    }
  }

  /**
   * @param isRobot whether the site has a robot of that name now
   * @param onRanges is told of ranges with the angles in which they were measured, by the robot's
   *     name; it does not wait
   * @throws org.toqa.persistence.StoreException the limits cannot be read
   */
  public Telemetry(
      String site,
      BrokerPlace broker,
      Predicate<String> isRobot,
      BiConsumer<String, Reading> onRanges,
      TelemetryStore store,
      InstantSource clock) {
    this.site = site;
    this.broker = broker;
    this.isRobot = isRobot;
    this.board = new ReadingBoard(isRobot, onRanges);
    this.store = store;
    this.clock = clock;
    this.limits = List.copyOf(store.limits());
  }

  public BrokerPlace broker() {
    return broker;
  }

  /** Takes in what robots publish. */
  public ReadingBoard board() {
    return board;
  }

  public RobotReadings readings(String robot) {
    return board.of(robot);
  }

  /** Of that robot's readings, by their names. */
  public List<ReadingLimits> limits(String robot) {
    return limits.stream().filter(limit -> limit.robot().equals(robot)).toList();
  }

  /**
   * Sets or removes them.
   *
   * @throws org.toqa.persistence.StoreException they are not stored, and stay as they were
   */
  public void setLimits(ReadingLimits changed) {
    store.setLimits(changed);
    limits = List.copyOf(store.limits());
  }

  /** What is wrong with readings, by robot. */
  public Map<String, Sentence> alerts() {
    Instant now = clock.instant();
    Map<String, Sentence> alerts = new LinkedHashMap<>();
    for (ReadingLimits limit : limits) {
      board.of(limit.robot()).readings().stream()
          .filter(reading -> reading.name().equals(limit.reading()))
          .filter(reading -> reading.receivedAt().plus(FRESH).isAfter(now))
          .flatMap(reading -> limit.violation(reading).stream())
          .forEach(sentence -> alerts.putIfAbsent(limit.robot(), sentence));
    }
    return alerts;
  }

  /** The name by which a robot publishes. */
  public String user(String robot) {
    return site + "/robot/" + robot;
  }

  public boolean hasPassword(String robot) {
    return store.passwordHash(robot).isPresent();
  }

  /**
   * Makes a password for a robot, instead of the one before. It is told but once.
   *
   * @param by who does it
   */
  public Login makePassword(String robot, String by) {
    String password = Secret.random();
    String hash = Secret.hash(password);
    store.setPasswordHash(robot, hash, by);
    hashes.put(robot, Optional.of(hash));
    return new Login(user(robot), password);
  }

  /**
   * Whether a robot of the site has that password now, within {@link #KNOWN_FOR}.
   *
   * @throws org.toqa.persistence.StoreException nobody knows now
   */
  public boolean isPassword(String robot, String password) {
    if (!Secret.isWellFormed(password) || !isRobot.test(robot)) {
      return false;
    }
    Optional<String> hash = hashes.get(robot, store::passwordHash);
    return hash.isPresent()
        && MessageDigest.isEqual(
            hash.get().getBytes(StandardCharsets.US_ASCII),
            Secret.hash(password).getBytes(StandardCharsets.US_ASCII));
  }
}
