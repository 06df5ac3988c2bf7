package org.toqa.notices;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.Hold;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.mission.Question;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * What of a snapshot needs attention: what the map page lists so, and what holds robots or hinders
 * the server.
 */
public final class Conditions {
  private static final Set<Phrase> OF_BATTERY =
      Set.of(Phrase.NO_WAY_TO_CHARGER, Phrase.CANNOT_REACH_CHARGER, Phrase.HARDLY_LASTS_FOR_LOAD);
  private static final Set<Phrase> OF_READING = Set.of(Phrase.READING_BELOW, Phrase.READING_ABOVE);

  private final List<Condition> found = new ArrayList<>();

  private Conditions() {}

  public static List<Condition> of(FleetSnapshot fleet) {
    Conditions conditions = new Conditions();
    fleet.alerts().forEach(conditions::addServer);
    Hold pause = fleet.pause();
    if (pause != null) {
      conditions.add(NoticeKind.FLEET_PAUSED, pause.since().toString(), null, pause.ofAll());
    }
    fleet.floors().forEach(conditions::addFloor);
    fleet.tasks().forEach(conditions::addTask);
    fleet.robots().forEach(conditions::addRobot);
    return List.copyOf(conditions.found);
  }

  private void addServer(Sentence alert) {
    // some say more as it goes on: the values are no part of the name
    add(
        NoticeKind.SERVER,
        alert.isVerbatim() ? alert.english() : alert.phrase().name(),
        null,
        alert);
  }

  private void addFloor(FloorView floor) {
    Hold hold = floor.hold();
    if (hold != null) {
      add(
          NoticeKind.FLOOR_HELD,
          floor.name() + " " + hold.since(),
          floor.name(),
          hold.ofFloor(floor.name()));
    }
    for (FloorView.StandstillView one : floor.standstills()) {
      String robots = String.join(", ", one.robots());
      add(NoticeKind.STANDSTILL, floor.name() + " " + robots, floor.name(), one.text());
    }
    for (FloorView.FaultyCharger one : floor.faultyChargers()) {
      add(NoticeKind.CHARGER_FAULTY, floor.name() + " " + one.name(), floor.name(), one.text());
    }
    FloorView.ChargerShortage shortage = floor.chargerShortage();
    if (shortage != null) {
      add(NoticeKind.CHARGERS_SHORT, floor.name(), floor.name(), shortage.text());
    }
    for (FloorView.LeftLoad one : floor.leftLoads()) {
      found.add(
          new Condition(
              NoticeKind.LOAD_LEFT,
              Long.toString(one.task()),
              floor.name(),
              one.task(),
              null,
              null,
              one.text()));
    }
  }

  private void add(NoticeKind kind, String subject, @Nullable String floor, Sentence text) {
    found.add(new Condition(kind, subject, floor, null, null, null, text));
  }

  private void addTask(TaskView view) {
    Question question = view.needs();
    Sentence late = view.late();
    Sentence waits = view.waitingFor();
    if (question != null) {
      addTask(NoticeKind.TASK_QUESTION, view, " " + question.kind(), question.question());
    } else if (view.blocked() && waits != null) {
      addTask(NoticeKind.TASK_BLOCKED, view, "", waits);
    }
    if (late != null) {
      addTask(NoticeKind.TASK_LATE, view, "", late);
    }
  }

  private void addTask(NoticeKind kind, TaskView view, String part, Sentence why) {
    TransportTask task = view.task();
    found.add(
        new Condition(
            kind,
            task.id() + part,
            task.floor(),
            task.id(),
            null,
            task.owner(),
            Phrase.NOTICE_OF_TASK.with(task.id(), task.name(), why)));
  }

  private void addRobot(RobotView robot) {
    if (robot.state() == RobotState.OUT_OF_SERVICE) {
      return; // a person has seen to it
    }
    List<Fault> faults = robot.telemetry().errors();
    if (isUnheard(robot)) {
      Sentence why = robot.unreachable();
      addRobot(
          NoticeKind.ROBOT_LOST, robot, "", why == null ? Phrase.NOTICE_ROBOT_LOST.with() : why);
    } else {
      faults.forEach(fault -> addFault(robot, fault));
      boolean isLeftOut = robot.work().doing().phrase() == Phrase.IS_LEFT_OUT;
      if (robot.state() == RobotState.ERROR && (faults.isEmpty() || isLeftOut)) {
        addRobot(NoticeKind.ROBOT_ERROR, robot, "", robot.work().doing());
      }
      if (robot.state() == RobotState.NOT_LOCALISED) {
        addRobot(
            NoticeKind.ROBOT_NOT_LOCALISED, robot, "", Phrase.NOTICE_ROBOT_NOT_LOCALISED.with());
      }
    }
    Sentence alert = robot.alert();
    if (alert != null) {
      addRobot(kindOf(alert), robot, " " + subjectOf(alert), alert);
    }
  }

  /** One that was not reached since the start is as lost as one that is not heard any more. */
  private static boolean isUnheard(RobotView robot) {
    return robot.state() == RobotState.LOST
        || (robot.state() == RobotState.CONNECTING && robot.unreachable() != null);
  }

  private void addFault(RobotView robot, Fault fault) {
    addRobot(
        fault.clearable() ? NoticeKind.ROBOT_STOPPED : NoticeKind.ROBOT_ERROR,
        robot,
        " " + fault.code(),
        Sentence.verbatim(fault.text()));
  }

  private void addRobot(NoticeKind kind, RobotView robot, String part, Sentence why) {
    found.add(
        new Condition(
            kind,
            robot.name() + part,
            robot.floor(),
            null,
            robot.name(),
            null,
            Phrase.NOTICE_OF_ROBOT.with(robot.name(), why)));
  }

  private static NoticeKind kindOf(Sentence alert) {
    if (OF_BATTERY.contains(alert.phrase())) {
      return NoticeKind.ROBOT_BATTERY;
    }
    return OF_READING.contains(alert.phrase()) ? NoticeKind.ROBOT_READING : NoticeKind.ROBOT_ALERT;
  }

  /** Which reading it is, but not what it reads. */
  private static String subjectOf(Sentence alert) {
    return OF_READING.contains(alert.phrase())
        ? alert.phrase() + " " + alert.values().getFirst()
        : alert.phrase().name();
  }
}
