package org.toqa.fleet;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.apache.pekko.actor.typed.ActorRef;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.Energy;
import org.toqa.fleet.ChargeRecord.Turn;
import org.toqa.fleet.FloorRobot.Errand;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Place;
import org.toqa.mission.Carrier;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Lets robots charge (CMCT, "Self-recharging"): one whose battery is low, or that has worked for
 * long since it last charged, takes a turn at the charging point where it can begin soonest, and
 * waits for those that were there before. It is never taken from a load on board; before the
 * pick-up only where its battery would not last. A turn is stored before the robot moves for it.
 */
final class Charging {
  /** Another charging point is worth a change of mind if it saves so much. */
  private static final double WORTHWHILE_SECONDS = 60;

  /** How often the time that a robot has worked is written down. */
  private static final Duration WRITTEN_EVERY = Duration.ofMinutes(1);

  private final FloorState state;
  private final FloorMissions missions;
  private final ChargingRules rules;
  private final ChargingQueues queues;
  private final ActorRef<FloorMessage> self;
  private Instant lastLook;

  Charging(
      FloorState state, FloorMissions missions, ChargingRules rules, ActorRef<FloorMessage> self) {
    this.state = state;
    this.missions = missions;
    this.rules = rules;
    this.queues = new ChargingQueues(state, rules);
    this.self = self;
    this.lastLook = state.now;
  }

  /** Goes on with what was stored before a restart. */
  void recover(ChargeRecord record) {
    FloorRobot robot = state.robots.get(record.robot());
    if (robot != null) {
      robot.worked = record.worked();
      robot.workWritten = record.worked();
      robot.turn = record.turn();
      robot.turnStored = true;
    }
  }

  /** To be called once a tick. */
  void look() {
    Duration passed = Duration.between(lastLook, state.now);
    lastLook = state.now;
    if (state.floor.charging().isEmpty()) {
      return;
    }
    state.chargers.forget(state.now);
    for (FloorRobot robot : state.robots.values()) {
      countWork(robot, passed);
      if (robot.turn == null) {
        whyItMust(robot).ifPresentOrElse(why -> begin(robot, why), () -> says(robot, null));
      } else if (robot.turnStored) {
        goOn(robot, robot.turn);
      }
    }
  }

  /** No task suits what these robots have left, though they are free. */
  void isWanted(FloorMessage.Recharge m) {
    for (String name : m.robots()) {
      FloorRobot robot = state.robots.get(name);
      if (robot != null && robot.turn == null) {
        robot.lacksFor = m.task();
      }
    }
  }

  /** That is safe: now the robot may move for it. */
  void stored(FloorMessage.ChargeStored m) {
    FloorRobot robot = state.robots.get(m.robot());
    if (robot != null && Objects.equals(robot.turn, m.turn())) {
      robot.turnStored = true;
    }
  }

  private void countWork(FloorRobot robot, Duration passed) {
    if (robot.errand == null || robot.turn != null) {
      return;
    }
    robot.worked = robot.worked.plus(passed);
    if (robot.worked.minus(robot.workWritten).compareTo(WRITTEN_EVERY) >= 0) {
      robot.workWritten = robot.worked;
      ChargeRecord record = record(robot);
      state.writer.write(() -> state.store.saveCharge(record, List.of()), () -> {});
    }
  }

  // --- whether ----------------------------------------------------------------------------------

  /** A clause; empty while it need not charge or cannot be taken from its task. */
  private Optional<Sentence> whyItMust(FloorRobot robot) {
    Double battery = robot.battery;
    if (battery == null || !robot.isFit()) {
      return Optional.empty();
    }
    Optional<Mission> mission = state.missions.of(robot.name());
    return switch (mission.map(m -> phase(m, robot)).orElse(0)) {
      case 1 ->
          battery < rules.below() && !lastsFor(mission.orElseThrow(), robot, battery)
              ? Optional.of(Phrase.NOT_ENOUGH_FOR_ITS_TASK.with(percent(battery)))
              : Optional.empty();
      case 2 -> Optional.empty();
      default -> Optional.ofNullable(due(robot, battery));
    };
  }

  private static int phase(Mission mission, FloorRobot robot) {
    return mission.carrier(robot.name()).map(Carrier::phase).orElse(0);
  }

  private @Nullable Sentence due(FloorRobot robot, double battery) {
    if (battery < rules.below()) {
      return Phrase.BATTERY_HAS.with(percent(battery));
    }
    if (robot.worked.compareTo(rules.work()) >= 0) {
      return Phrase.HAS_WORKED_FOR.with(robot.worked.toSeconds() / 3600.0);
    }
    return robot.lacksFor != null && battery < rules.until()
        ? Phrase.NOT_ENOUGH_FOR_TASK.with(percent(battery), robot.lacksFor)
        : null;
  }

  private boolean lastsFor(Mission mission, FloorRobot robot, double battery) {
    if (robot.pose == null) {
      return true;
    }
    Vec2 object = mission.object().position();
    Vec2 goal = mission.destination().position();
    double used =
        Energy.joules(queues.metres(robot, robot.pose.position(), object), 0)
            + Energy.joules(queues.metres(robot, object, goal), mission.task().load())
            + Energy.joules(queues.metresToCharger(robot, goal), 0);
    return used < battery * Energy.BATTERY;
  }

  // --- where ------------------------------------------------------------------------------------

  private void begin(FloorRobot robot, Sentence why) {
    Optional<Place> point = queues.soonest(robot).map(ChargingQueues.Choice::point);
    if (point.isEmpty()) {
      says(robot, Phrase.NO_WAY_TO_CHARGER.with());
      return;
    }
    takeTurn(robot, point.get(), why);
    state
        .missions
        .of(robot.name())
        .ifPresent(
            mission ->
                missions.happened(mission.id(), new MissionEvent.MustCharge(robot.name(), why)));
  }

  private void takeTurn(FloorRobot robot, Place point, Sentence why) {
    robot.turn = new Turn(point.name(), state.now);
    robot.lacksFor = null;
    List<FloorRobot> ahead = queues.ahead(robot, point);
    if (ahead.isEmpty()) {
      Sentence text = Phrase.ROBOT_DRIVES_TO_CHARGER.with(robot.name(), point.name(), why);
      save(robot, "robot.to-charger", text);
    } else {
      Sentence text = Phrase.ROBOT_AWAITS_CHARGER.with(robot.name(), charger(point, ahead), why);
      save(robot, "robot.waits-for-charger", text);
    }
  }

  // --- on its way, waiting, charging ------------------------------------------------------------

  private void goOn(FloorRobot robot, Turn turn) {
    Optional<Place> point =
        state.floor.charging().stream().filter(p -> p.name().equals(turn.point())).findFirst();
    if (point.isEmpty()) {
      giveUp(robot, Phrase.CHARGER_IS_GONE.with(turn.point()));
    } else if (!robot.inService) {
      giveUp(robot, Phrase.LEFT_SERVICE.with());
    } else if (robot.isHeard() && !goesElsewhere(robot, point.get())) {
      List<FloorRobot> ahead = queues.ahead(robot, point.get());
      if (ahead.isEmpty()) {
        goOn(robot, point.get());
      } else {
        await(robot, point.get(), ahead);
      }
    }
  }

  /** Leaves a point that does not charge for one that may. */
  private boolean goesElsewhere(FloorRobot robot, Place point) {
    if (!state.chargers.fails(point) || !robot.isFit()) {
      return false;
    }
    Optional<Place> other =
        queues
            .soonest(robot)
            .map(ChargingQueues.Choice::point)
            .filter(choice -> !state.chargers.fails(choice));
    other.ifPresent(
        choice -> takeTurn(robot, choice, Phrase.CHARGER_DOES_NOT_CHARGE.with(point.name())));
    return other.isPresent();
  }

  private void goOn(FloorRobot robot, Place point) {
    boolean isThere = queues.isAt(robot, point) && robot.isStanding();
    if (!isThere) {
      says(robot, Phrase.DRIVES_TO_CHARGER.with(point.name()));
    } else if (!robot.charging) {
      says(robot, Phrase.CHARGES_AT.with(point.name()));
      if (robot.errand != null) { // else it stood there when the server started
        note(robot, "robot.charging", Phrase.ROBOT_CHARGES.with(robot.name(), point.name()));
      }
    }
    robot.charging = isThere;
    robot.errand = Errand.charge(point.position());
    if (!isThere || robot.battery == null) {
      state.chargers.left(robot.name());
    } else if (robot.battery >= rules.until()) {
      isCharged(robot, point, robot.battery);
    } else if (robot.battery + ChargerWatch.RISE < rules.until()) {
      watch(robot, point, robot.battery);
    }
  }

  private void watch(FloorRobot robot, Place point, double battery) {
    switch (state.chargers.look(robot.name(), point, battery, state.now)) {
      case FAILS -> {
        says(robot, Phrase.STANDS_AT_FAULTY_CHARGER.with(point.name()));
        note(
            robot,
            "robot.charger-fails",
            Phrase.CHARGER_FAILS.with(point.name(), robot.name(), percent(battery)));
      }
      case WORKS_AGAIN -> {
        says(robot, Phrase.CHARGES_AT.with(point.name()));
        note(robot, "robot.charger-works", Phrase.CHARGER_WORKS_AGAIN.with(point.name()));
      }
      case NOTHING_NEW -> {}
    }
  }

  private void await(FloorRobot robot, Place point, List<FloorRobot> ahead) {
    robot.charging = false;
    if (robot.errand != null && robot.errand.task() == null) {
      robot.errand = null; // it may drive home meanwhile
    }
    says(robot, Phrase.AWAITS_CHARGER.with(charger(point, ahead)));
    if (!robot.isFit()) {
      return;
    }
    double here = queues.seconds(robot, point);
    queues
        .soonest(robot)
        .filter(choice -> choice.seconds() + WORTHWHILE_SECONDS < here)
        .ifPresent(choice -> takeTurn(robot, choice.point(), Phrase.IS_SOONER.with()));
  }

  private Sentence charger(Place point, List<FloorRobot> ahead) {
    FloorRobot first = ahead.getFirst();
    Phrase phrase = queues.isAt(first, point) ? Phrase.OCCUPIED_CHARGER : Phrase.CLAIMED_CHARGER;
    Sentence charger = phrase.with(point.name(), first.name());
    return ahead.size() == 1 ? charger : Phrase.AFTER_MORE.with(charger, ahead.size() - 1);
  }

  private void isCharged(FloorRobot robot, Place point, double battery) {
    robot.worked = Duration.ZERO;
    robot.workWritten = Duration.ZERO;
    end(
        robot,
        "robot.charged",
        Phrase.ROBOT_HAS_CHARGED.with(robot.name(), point.name(), percent(battery)));
  }

  private void giveUp(FloorRobot robot, Sentence why) {
    end(robot, "robot.charge-ended", Phrase.ROBOT_CHARGES_NO_MORE.with(robot.name(), why));
  }

  private void end(FloorRobot robot, String kind, Sentence text) {
    robot.turn = null;
    robot.charging = false;
    state.chargers.left(robot.name());
    robot.chargingSays = null;
    if (robot.errand != null && robot.errand.task() == null) {
      robot.errand = null;
    }
    save(robot, kind, text);
  }

  private void save(FloorRobot robot, String kind, Sentence text) {
    robot.turnStored = false;
    state.changed = true;
    ChargeRecord record = record(robot);
    EventRecord event = event(robot, kind, text);
    state.writer.write(
        () -> state.store.saveCharge(record, List.of(event)),
        () -> self.tell(new FloorMessage.ChargeStored(robot.name(), record.turn())));
  }

  private static ChargeRecord record(FloorRobot robot) {
    return new ChargeRecord(robot.name(), robot.worked, robot.turn);
  }

  private void note(FloorRobot robot, String kind, Sentence text) {
    state.note(event(robot, kind, text));
  }

  private EventRecord event(FloorRobot robot, String kind, Sentence text) {
    return state.event(kind, robot.name(), EventRecord.SYSTEM, text);
  }

  private void says(FloorRobot robot, @Nullable Sentence sentence) {
    if (!Objects.equals(sentence, robot.chargingSays)) {
      robot.chargingSays = sentence;
      state.changed = true;
    }
  }

  private static long percent(double battery) {
    return Math.round(100 * battery);
  }
}
