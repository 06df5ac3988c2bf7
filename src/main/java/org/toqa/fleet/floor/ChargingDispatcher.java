package org.toqa.fleet.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.apache.pekko.actor.typed.ActorRef;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.Energy;
import org.toqa.fleet.ChargeRecord;
import org.toqa.fleet.ChargeRecord.Turn;
import org.toqa.fleet.ChargingRules;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FloorView.ChargerShortage;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Place;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.LoadChoice;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Phase;
import org.toqa.mission.Stop;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Lets robots charge (CMCT, "Self-recharging"): one whose battery is low, or that has worked for
 * long since it last charged, takes a turn at the charging point where it can begin soonest, and
 * waits for those that were there before. It is never taken from a load on board, but where its
 * battery would not last a person is called; before the pick-up only where its battery would not
 * last. A turn is stored before the robot moves for it. Where a mission has a stop to charge at,
 * its robot takes such a turn too, and goes on when it has what was ordered.
 */
final class ChargingDispatcher {
  /** Another charging point is worth a change of mind if it saves so much. */
  private static final double WORTHWHILE_SECONDS = 60;

  /** How often the time that a robot has worked is written down. */
  private static final Duration WRITE_INTERVAL = Duration.ofMinutes(1);

  private final FloorState state;
  private final FloorMissions missions;
  private final ChargingRules rules;
  private final ChargingQueues queues;
  private final ChargerDemand demand = new ChargerDemand();
  private final ActorRef<FloorMessage> self;
  private Instant lastUpdate;

  ChargingDispatcher(
      FloorState state, FloorMissions missions, ChargingRules rules, ActorRef<FloorMessage> self) {
    this.state = state;
    this.missions = missions;
    this.rules = rules;
    this.queues = new ChargingQueues(state, rules);
    this.self = self;
    this.lastUpdate = state.now;
  }

  /** Goes on with what was stored before a restart. */
  void recover(ChargeRecord record) {
    FloorRobot robot = state.robots.get(record.robot());
    if (robot != null) {
      robot.charging.recover(record);
    }
  }

  /** To be called once a tick. */
  void update() {
    Duration passed = Duration.between(lastUpdate, state.now);
    lastUpdate = state.now;
    state.chargers.forgetExpired(state.now);
    state.robots.values().forEach(this::updateOrdered);
    if (state.floor.charging().isEmpty()) {
      return;
    }
    for (FloorRobot robot : state.robots.values()) {
      addWork(robot, passed);
      Optional<Turn> turn = robot.charging.turn();
      if (robot.charging.isForTask()) {
        if (turn.isPresent() && robot.charging.isTurnStored()) {
          continueTurn(robot, turn.get());
        }
      } else if (turn.isEmpty()) {
        chargingReason(robot).ifPresentOrElse(why -> begin(robot, why), () -> watchLoaded(robot));
      } else if (robot.charging.isTurnStored()) {
        continueTurn(robot, turn.get());
      }
    }
    updateDemand(passed);
  }

  // --- for a task -------------------------------------------------------------------------------

  /** Takes a turn for a mission that charges next, and ends it when that goes on. */
  private void updateOrdered(FloorRobot robot) {
    Optional<Mission> mission = chargingMission(robot);
    if (mission.isEmpty()) {
      if (robot.charging.isForTask() || isLeftOver(robot)) {
        endOrdered(robot);
      }
      return;
    }
    robot.charging.setForTask(true);
    boolean isStored = state.missions.storedMissionOf(robot.name()).equals(mission);
    if (isStored && !robot.charging.hasTurn() && robot.isFit() && !robot.hold.isHeld()) {
      beginOrdered(robot, mission.get());
    }
  }

  /**
   * Whether its mission had gone on when the server was killed, and its turn had not ended: for
   * itself no robot charges while it works for a mission.
   */
  private boolean isLeftOver(FloorRobot robot) {
    return robot.charging.isTurnStored()
        && state
            .missions
            .missionOf(robot.name())
            .filter(mission -> phase(mission, robot).isCarryingTask())
            .isPresent();
  }

  /** The mission whose next stop, or this one, is to charge. */
  private Optional<Mission> chargingMission(FloorRobot robot) {
    return state
        .missions
        .missionOf(robot.name())
        .filter(mission -> mission.chargingStop().isPresent());
  }

  private void beginOrdered(FloorRobot robot, Mission mission) {
    String name = charge(mission).charger();
    Optional<Place> point =
        name == null ? queues.soonest(robot).map(ChargingQueues.Choice::point) : point(name);
    if (point.isPresent()) {
      takeTurn(robot, point.get(), Phrase.TASK_CHARGES_IT.with(mission.id()));
    } else {
      askForHelp(
          robot,
          name == null
              ? Phrase.NO_WAY_TO_CHARGER.with()
              : Phrase.CHARGER_OF_TASK_IS_GONE.with(name, mission.id()));
    }
  }

  private static Stop.Charge charge(Mission mission) {
    return Objects.requireNonNull(mission.chargingStop().orElseThrow().charge());
  }

  private Optional<Place> point(String name) {
    return state.floor.charging().stream().filter(p -> p.name().equals(name)).findFirst();
  }

  /** Whether it may charge nowhere else. */
  private boolean isBoundToCharger(FloorRobot robot) {
    return chargingMission(robot).filter(mission -> charge(mission).charger() != null).isPresent();
  }

  private void endOrdered(FloorRobot robot) {
    Double battery = robot.reported.battery();
    Optional<Turn> turn = robot.charging.turn();
    if (turn.isPresent() && robot.charging.isCharging() && battery != null) {
      endTurn(
          robot,
          EventKind.ROBOT_CHARGED,
          Phrase.ROBOT_HAS_CHARGED.with(robot.name(), turn.get().point(), percent(battery)));
    } else if (turn.isPresent()) {
      abandonTurn(robot, Phrase.TASK_CHARGES_IT_NO_MORE.with());
    } else {
      robot.charging.endTurn();
      state.changed = true;
    }
  }

  /** The level counts from when it is at the stop, and lets nobody go on who is on hold. */
  private void endWhereCharged(Mission mission, double battery) {
    mission
        .waitingStop()
        .filter(_ -> !mission.held() && mission.trouble() == null)
        .flatMap(stop -> stop.chargesUntil(rules.until()))
        .filter(level -> battery >= level)
        .ifPresent(
            _ ->
                missions.applyEvent(
                    mission.id(),
                    new MissionEvent.ChargeEnded(mission.progress().stop(), battery)));
  }

  private void updateDemand(Duration passed) {
    int charging = 0;
    int waiting = 0;
    int other = 0;
    for (FloorRobot robot : state.robots.values()) {
      boolean isActive = robot.isFit() || robot.charging.isCharging();
      if (isActive && !robot.charging.hasTurn()) {
        other++;
      } else if (isActive && robot.charging.isAwaitingTurn()) {
        waiting++;
      } else if (isActive) {
        charging++;
      }
    }
    demand.observe(charging, waiting, other, passed, state.now);
    ChargerShortage shortage =
        demand.shortage(state.floor.charging().size(), charging + waiting + other).orElse(null);
    state.changed |= !Objects.equals(needed(shortage), needed(state.chargerShortage));
    state.chargerShortage = shortage;
  }

  private static @Nullable Integer needed(@Nullable ChargerShortage shortage) {
    return shortage == null ? null : shortage.needed();
  }

  /** No task suits what these robots have left, though they are free. */
  void requestRecharge(FloorMessage.RechargeRobots m) {
    for (String name : m.robots()) {
      FloorRobot robot = state.robots.get(name);
      if (robot != null && !robot.charging.hasTurn()) {
        robot.charging.setTaskBeyondBattery(m.task());
      }
    }
  }

  /** That is safe: now the robot may move for it. */
  void turnStored(FloorMessage.ChargeStored m) {
    FloorRobot robot = state.robots.get(m.robot());
    if (robot != null) {
      robot.charging.confirmStored(m.turn());
    }
  }

  private void addWork(FloorRobot robot, Duration passed) {
    if (robot.drive.goal() == null || robot.charging.hasTurn()) {
      return;
    }
    if (robot.charging.addWork(passed, WRITE_INTERVAL)) {
      ChargeRecord record = robot.charging.record(robot.name());
      state.writer.write(() -> state.store.saveCharge(record, List.of()), () -> {});
    }
  }

  // --- whether ----------------------------------------------------------------------------------

  /** A clause; empty while it need not charge or cannot be taken from its task. */
  private Optional<Sentence> chargingReason(FloorRobot robot) {
    Double battery = robot.reported.battery();
    if (battery == null || !robot.isFit()) {
      return Optional.empty();
    }
    Optional<Mission> mission = state.missions.missionOf(robot.name());
    return switch (mission.map(m -> phase(m, robot)).orElse(Phase.NONE)) {
      case TO_OBJECT ->
          mission.flatMap(Mission::chargingStop).isEmpty()
                  && battery < rules.below()
                  && !isBatteryEnoughFor(mission.orElseThrow(), robot, battery)
              ? Optional.of(Phrase.NOT_ENOUGH_FOR_ITS_TASK.with(percent(battery)))
              : Optional.empty();
      case TO_GOAL -> Optional.empty();
      case HOME, NONE -> Optional.ofNullable(dueReason(robot, battery));
    };
  }

  /** Calls a person where a load keeps it from charging and its battery hardly lasts. */
  private void watchLoaded(FloorRobot robot) {
    Double battery = robot.reported.battery();
    Optional<Mission> unsure =
        state
            .missions
            .missionOf(robot.name())
            .filter(mission -> phase(mission, robot) == Phase.TO_GOAL)
            .filter(
                mission ->
                    battery != null && robot.isFit() && isRunningLow(mission, robot, battery));
    if (battery != null && unsure.isPresent()) {
      askForHelp(robot, Phrase.HARDLY_LASTS_FOR_LOAD.with(percent(battery), unsure.get().id()));
    } else {
      setStatus(robot, null);
    }
  }

  /**
   * Whether it would not reach a charging point after its load is delivered; while it waits for who
   * lets it go on, also where it would get there with less than the reserve.
   */
  private boolean isRunningLow(Mission mission, FloorRobot robot, double battery) {
    boolean isWaiting = robot.hold.isHeld() || mission.waitingStop().isPresent();
    Pose pose = robot.reported.pose();
    if (pose == null || (!isWaiting && battery >= rules.below())) {
      return false;
    }
    List<Stop> ahead =
        mission.ending() == LoadChoice.BACK
            ? List.of(Stop.at(mission.task().start()))
            : mission.task().route().subList(mission.stopNumber(), mission.task().route().size());
    double used = joulesAlong(mission, robot, pose.position(), ahead);
    double left = battery - (Double.isFinite(used) ? used : 0) / Energy.BATTERY_JOULES;
    return left < (isWaiting ? Energy.RESERVE : 0);
  }

  /** Whether the battery lasts to the nearest charging point to which there is a path. */
  private boolean isInReach(FloorRobot robot, double battery) {
    return joulesToCharger(robot) < battery * Energy.BATTERY_JOULES;
  }

  /** Joules; 0 where it is not known. */
  private double joulesToCharger(FloorRobot robot) {
    Pose pose = robot.reported.pose();
    double metres = pose == null ? 0 : queues.metresToCharger(robot, pose.position());
    return Double.isFinite(metres) ? Energy.joules(metres, 0) : 0;
  }

  private static Phase phase(Mission mission, FloorRobot robot) {
    return mission.assignedRobot(robot.name()).map(AssignedRobot::phase).orElse(Phase.NONE);
  }

  private @Nullable Sentence dueReason(FloorRobot robot, double battery) {
    if (battery < rules.below()
        || (battery - Energy.RESERVE) * Energy.BATTERY_JOULES < joulesToCharger(robot)) {
      return Phrase.BATTERY_HAS.with(percent(battery));
    }
    Duration worked = robot.charging.workedSinceCharge();
    if (worked.compareTo(rules.work()) >= 0) {
      return Phrase.HAS_WORKED_FOR.with(worked.toSeconds() / 3600.0);
    }
    Long task = robot.charging.taskBeyondBattery();
    return task != null && battery < rules.until()
        ? Phrase.NOT_ENOUGH_FOR_TASK.with(percent(battery), task)
        : null;
  }

  private boolean isBatteryEnoughFor(Mission mission, FloorRobot robot, double battery) {
    Pose pose = robot.reported.pose();
    if (pose == null) {
      return true;
    }
    Vec2 at = mission.object().position();
    int next = mission.task().stopAfterFirst(mission.progress());
    List<Stop> ahead = mission.task().route().stream().skip(next).toList();
    double used =
        Energy.joules(queues.metres(robot, pose.position(), at), 0)
            + joulesAlong(mission, robot, at, ahead);
    return used < battery * Energy.BATTERY_JOULES;
  }

  /** Of the way with its share of the load to the stops, until it charges at one or after them. */
  private double joulesAlong(Mission mission, FloorRobot robot, Vec2 from, List<Stop> stops) {
    double share = state.formations.share(mission, robot.name());
    double used = 0;
    Vec2 at = from;
    for (Stop stop : stops) {
      Vec2 place = stop.place().position();
      used += Energy.joules(queues.metres(robot, at, place), share);
      at = place;
      if (stop.charge() != null) {
        return used;
      }
    }
    return used + Energy.joules(queues.metresToCharger(robot, at), 0);
  }

  // --- where ------------------------------------------------------------------------------------

  private void begin(FloorRobot robot, Sentence why) {
    Optional<Place> point = queues.soonest(robot).map(ChargingQueues.Choice::point);
    if (point.isEmpty()) {
      askForHelp(robot, Phrase.NO_WAY_TO_CHARGER.with());
      return;
    }
    takeTurn(robot, point.get(), why);
    state
        .missions
        .missionOf(robot.name())
        .ifPresent(
            mission ->
                missions.applyEvent(
                    mission.id(), new MissionEvent.ChargingRequired(robot.name(), why)));
  }

  private void takeTurn(FloorRobot robot, Place point, Sentence why) {
    robot.charging.takeTurn(new Turn(point.name(), state.now));
    List<FloorRobot> ahead = queues.robotsAhead(robot, point);
    if (ahead.isEmpty()) {
      Sentence text = Phrase.ROBOT_DRIVES_TO_CHARGER.with(robot.name(), point.name(), why);
      saveTurn(robot, EventKind.ROBOT_TO_CHARGER, text);
    } else {
      Sentence text =
          Phrase.ROBOT_AWAITS_CHARGER.with(robot.name(), chargerSentence(point, ahead), why);
      saveTurn(robot, EventKind.ROBOT_WAITS_FOR_CHARGER, text);
    }
  }

  // --- driving there, waiting, charging ---------------------------------------------------------

  private void continueTurn(FloorRobot robot, Turn turn) {
    Optional<Place> point = point(turn.point());
    if (point.isEmpty()) {
      abandonTurn(robot, Phrase.CHARGER_IS_GONE.with(turn.point()));
    } else if (!robot.settings.isInService()) {
      abandonTurn(robot, Phrase.LEFT_SERVICE.with());
    } else if (robot.isHeard() && !switchFromFaultyCharger(robot, point.get())) {
      List<FloorRobot> ahead = queues.robotsAhead(robot, point.get());
      if (ahead.isEmpty()) {
        continueTurn(robot, point.get());
      } else {
        waitForTurn(robot, point.get(), ahead);
      }
    }
  }

  /** Leaves a point that does not charge for one that may. */
  private boolean switchFromFaultyCharger(FloorRobot robot, Place point) {
    if (!state.chargers.isFaulty(point) || !robot.isFit() || isBoundToCharger(robot)) {
      return false;
    }
    Optional<Place> other =
        queues
            .soonest(robot)
            .map(ChargingQueues.Choice::point)
            .filter(choice -> !state.chargers.isFaulty(choice));
    other.ifPresent(
        choice -> takeTurn(robot, choice, Phrase.CHARGER_DOES_NOT_CHARGE.with(point.name())));
    return other.isPresent();
  }

  private void continueTurn(FloorRobot robot, Place point) {
    boolean isThere = queues.isAt(robot, point) && robot.isStanding();
    Double battery = robot.reported.battery();
    if (!isThere && battery != null && !isInReach(robot, battery)) {
      askForHelp(robot, Phrase.CANNOT_REACH_CHARGER.with(percent(battery), point.name()));
    } else if (!isThere) {
      setStatus(robot, Phrase.DRIVES_TO_CHARGER.with(point.name()));
    } else if (!robot.charging.isCharging()) {
      setStatus(robot, Phrase.CHARGES_AT.with(point.name()));
      // else it was there when the server started, or has made room for another
      if (robot.drive.goal() != null && !robot.charging.hasBegun()) {
        addToHistory(
            robot, EventKind.ROBOT_CHARGING, Phrase.ROBOT_CHARGES.with(robot.name(), point.name()));
      }
    }
    robot.charging.setCharging(isThere);
    robot.charging.setAwaitingTurn(false);
    Optional<Mission> mission = chargingMission(robot);
    robot.drive.setGoal(
        mission
            .map(ordered -> state.formations.driveGoal(ordered, robot.name()))
            .orElse(DriveGoal.toCharger(point.position())));
    if (!isThere || battery == null) {
      state.chargers.robotLeft(robot.name());
    } else if (mission.isPresent()) {
      if (battery + ChargerWatch.MIN_RISE < rules.until()) {
        watchBattery(robot, point, battery);
      }
      endWhereCharged(mission.get(), battery);
    } else if (battery >= rules.until()
        || (battery >= rules.untilWhileOthersWait() && queues.isAwaitedByOthers(robot, point))) {
      finishCharging(robot, point, battery);
    } else if (battery + ChargerWatch.MIN_RISE < rules.until()) {
      watchBattery(robot, point, battery);
    }
  }

  private void watchBattery(FloorRobot robot, Place point, double battery) {
    switch (state.chargers.observe(robot.name(), point, battery, state.now)) {
      case FAILED -> {
        setStatus(robot, Phrase.STANDS_AT_FAULTY_CHARGER.with(point.name()));
        addToHistory(
            robot,
            EventKind.ROBOT_CHARGER_FAILS,
            Phrase.CHARGER_FAILS.with(point.name(), robot.name(), percent(battery)));
      }
      case RECOVERED -> {
        setStatus(robot, Phrase.CHARGES_AT.with(point.name()));
        addToHistory(
            robot, EventKind.ROBOT_CHARGER_WORKS, Phrase.CHARGER_WORKS_AGAIN.with(point.name()));
      }
      case UNCHANGED -> {}
    }
  }

  private void waitForTurn(FloorRobot robot, Place point, List<FloorRobot> ahead) {
    robot.charging.setCharging(false);
    if (!robot.charging.isAwaitingTurn()) {
      robot.drive.dropGoalWithoutTask(); // it drives home meanwhile
    }
    robot.charging.setAwaitingTurn(true);
    chargingMission(robot).map(Mission::id).ifPresent(robot.drive::dropGoal);
    setStatus(robot, Phrase.AWAITS_CHARGER.with(chargerSentence(point, ahead)));
    if (!robot.isFit() || isBoundToCharger(robot)) {
      return;
    }
    double here = queues.secondsUntilCharging(robot, point);
    queues
        .soonest(robot)
        .filter(choice -> choice.seconds() + WORTHWHILE_SECONDS < here)
        .ifPresent(choice -> takeTurn(robot, choice.point(), Phrase.IS_SOONER.with()));
  }

  private Sentence chargerSentence(Place point, List<FloorRobot> ahead) {
    FloorRobot first = ahead.getFirst();
    Phrase phrase = queues.isAt(first, point) ? Phrase.OCCUPIED_CHARGER : Phrase.CLAIMED_CHARGER;
    Sentence charger = phrase.with(point.name(), first.name());
    return ahead.size() == 1 ? charger : Phrase.AFTER_MORE.with(charger, ahead.size() - 1);
  }

  private void finishCharging(FloorRobot robot, Place point, double battery) {
    robot.charging.resetWork();
    endTurn(
        robot,
        EventKind.ROBOT_CHARGED,
        Phrase.ROBOT_HAS_CHARGED.with(robot.name(), point.name(), percent(battery)));
  }

  private void abandonTurn(FloorRobot robot, Sentence why) {
    endTurn(
        robot, EventKind.ROBOT_CHARGE_ENDED, Phrase.ROBOT_CHARGES_NO_MORE.with(robot.name(), why));
  }

  private void endTurn(FloorRobot robot, EventKind kind, Sentence text) {
    robot.charging.endTurn();
    state.chargers.robotLeft(robot.name());
    robot.drive.dropGoalWithoutTask();
    saveTurn(robot, kind, text);
  }

  private void saveTurn(FloorRobot robot, EventKind kind, Sentence text) {
    state.changed = true;
    ChargeRecord record = robot.charging.record(robot.name());
    EventRecord event = event(robot, kind, text);
    state.writer.write(
        () -> state.store.saveCharge(record, List.of(event)),
        () -> self.tell(new FloorMessage.ChargeStored(robot.name(), record.turn())));
  }

  private void addToHistory(FloorRobot robot, EventKind kind, Sentence text) {
    state.addToHistory(event(robot, kind, text));
  }

  private EventRecord event(FloorRobot robot, EventKind kind, Sentence text) {
    return state.historyEvent(kind, robot.name(), EventRecord.SYSTEM, text);
  }

  private void setStatus(FloorRobot robot, @Nullable Sentence sentence) {
    state.changed |= robot.charging.setStatus(sentence, false);
  }

  private void askForHelp(FloorRobot robot, Sentence sentence) {
    state.changed |= robot.charging.setStatus(sentence, true);
  }

  private static long percent(double battery) {
    return Math.round(100 * battery);
  }
}
