package org.toqa.telemetry;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.Collections;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.RateLimit;

/**
 * What robots published last, as far as it is believed: the newest of each reading of each robot.
 * What comes too fast waits, the newest of each reading, until {@link #update}; the rest is
 * counted. It knows no clock: time is handed in. Any thread may call it.
 */
public final class ReadingBoard {
  static final int MAX_READINGS = 32;
  static final int READINGS_A_SECOND = 20;
  static final int READINGS_AT_ONCE = 40;

  private final Predicate<String> isRobot;
  private final BiConsumer<String, Reading> onRanges;
  private final Map<String, RobotBoard> robots = new HashMap<>();
  private long strangers;

  /**
   * Whether the robot's client is connected, as it says itself.
   *
   * @param since when the server heard it
   */
  public record Presence(boolean online, Instant since) {}

  /**
   * What is known of a robot.
   *
   * @param readings by name
   * @param presence null: its client has not said it
   * @param refusals how often, since the server's start
   */
  public record RobotReadings(
      List<Reading> readings, @Nullable Presence presence, Map<Refusal, Long> refusals) {
    public static final RobotReadings NONE = new RobotReadings(List.of(), null, Map.of());

    public RobotReadings {
      readings = List.copyOf(readings);
      refusals = Collections.unmodifiableMap(new TreeMap<>(refusals));
    }
  }

  /** A reading of a robot: the last that was believed, and the body that waits, if one does. */
  private static final class Slot {
    private @Nullable Reading newest;
    private byte @Nullable [] waiting;

    /** When that was heard. */
    private Instant heardAt = Instant.EPOCH;
  }

  private static final class RobotBoard {
    private final Map<String, Slot> slots = new TreeMap<>();
    private final Map<Refusal, Long> refusals = new EnumMap<>(Refusal.class);
    private final Consumer<Reading> onRanges;
    private final RateLimit limit;
    private @Nullable Presence presence;
    private Instant now = Instant.EPOCH;

    private RobotBoard(Consumer<Reading> onRanges) {
      this.onRanges = onRanges;
      limit = new RateLimit(READINGS_AT_ONCE, READINGS_A_SECOND, Duration.ofSeconds(1), () -> now);
    }

    private void refuse(Refusal why) {
      refusals.merge(why, 1L, Long::sum);
    }

    private void receive(String reading, byte[] body) {
      Slot slot = slots.get(reading);
      if (slot == null) {
        if (slots.size() >= MAX_READINGS) {
          refuse(Refusal.TOO_MANY_READINGS);
          return;
        }
        slot = new Slot();
        slots.put(reading, slot);
      }
      if (slot.waiting != null) {
        refuse(Refusal.TOO_OFTEN);
      }
      slot.waiting = body;
      slot.heardAt = now;
      if (limit.tryAcquire()) {
        take(reading, slot);
      }
    }

    private void take(String name, Slot slot) {
      byte[] body = Objects.requireNonNull(slot.waiting);
      slot.waiting = null;
      switch (ReadingParser.parse(name, body, slot.heardAt)) {
        case ReadingParser.Result.Read(Reading reading) -> {
          slot.newest = reading;
          if (!reading.angles().isEmpty() && slot.heardAt.equals(now)) {
            onRanges.accept(reading);
          }
        }
        case ReadingParser.Result.Refused(Refusal why) -> refuse(why);
      }
    }

    private void takeAllWaiting() {
      slots.forEach(
          (name, slot) -> {
            if (slot.waiting != null) {
              take(name, slot);
            }
          });
      slots.values().removeIf(slot -> slot.newest == null); // a name with nothing believed in it
    }

    private void receivePresence(byte[] body) {
      String word =
          body.length > ReadingParser.MAX_BYTES ? "" : new String(body, StandardCharsets.UTF_8);
      switch (word.strip()) {
        case "online" -> setPresence(true);
        case "offline" -> setPresence(false);
        default -> refuse(Refusal.UNREADABLE);
      }
    }

    private void setPresence(boolean online) {
      if (presence == null || presence.online() != online) {
        presence = new Presence(online, now);
      }
    }

    private RobotReadings view() {
      return new RobotReadings(
          slots.values().stream()
              .flatMap(slot -> Optional.ofNullable(slot.newest).stream())
              .toList(),
          presence,
          refusals);
    }
  }

  /**
   * @param isRobot whether the site has a robot of that name now; whoever has none is only counted
   * @param onRanges is told of ranges with the angles in which they were measured, by the robot's
   *     name, unless they had to wait: the robot is elsewhere by then; it does not wait
   */
  public ReadingBoard(Predicate<String> isRobot, BiConsumer<String, Reading> onRanges) {
    this.isRobot = isRobot;
    this.onRanges = onRanges;
  }

  /**
   * Takes in a message.
   *
   * @param origin of its topic; empty: it is none of a reading
   * @param retained whether the broker had kept it for later
   */
  public void receive(Optional<Topics.Origin> origin, byte[] body, boolean retained, Instant now) {
    boolean isKnown = origin.isPresent() && isRobot.test(origin.get().robot());
    synchronized (this) {
      if (!isKnown) {
        strangers++;
        return;
      }
      RobotBoard robot =
          robots.computeIfAbsent(
              origin.get().robot(),
              name -> new RobotBoard(ranges -> onRanges.accept(name, ranges)));
      robot.now = now;
      if (origin.get().reading().equals(Topics.CONNECTION)) {
        robot.receivePresence(body);
      } else if (retained) {
        robot.refuse(Refusal.RETAINED);
      } else {
        robot.receive(origin.get().reading(), body);
      }
    }
  }

  /** Takes in what waits, and forgets robots that are no more. To be called each second. */
  public synchronized void update(Instant now) {
    robots.keySet().removeIf(isRobot.negate());
    robots
        .values()
        .forEach(
            robot -> {
              robot.now = now;
              robot.takeAllWaiting();
            });
  }

  public synchronized RobotReadings of(String robot) {
    RobotBoard known = robots.get(robot);
    return known == null ? RobotReadings.NONE : known.view();
  }

  /** How many messages were of no robot of the site. */
  public synchronized long strangers() {
    return strangers;
  }
}
