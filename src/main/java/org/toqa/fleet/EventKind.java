package org.toqa.fleet;

import java.util.Arrays;
import org.toqa.mission.MissionEvent;

/** What a line of the history tells, for programs that read it. */
public enum EventKind {
  TASK_ADDED("task.added"),
  TASK_ANSWERED("task.answered"),
  TASK_AT_STOP("task.at-stop"),
  TASK_WENT_ON("task.went-on"),
  TASK_ASSIGNED("task.assigned"),
  TASK_AT_OBJECT("task.at-object"),
  TASK_CANCELLED("task.cancelled"),
  TASK_DELIVERED("task.delivered"),
  TASK_DELETED("task.deleted"),
  TASK_EDITED("task.edited"),
  TASK_EXCHANGED("task.exchanged"),
  TASK_HANDED_OVER("task.handed-over"),
  TASK_HELD("task.held"),
  TASK_LATE("task.late"),
  TASK_LOAD_FETCHED("task.load-fetched"),
  TASK_LOAD_MOVED("task.load-moved"),
  TASK_LOAD_REMOVED("task.load-removed"),
  TASK_PARKED("task.parked"),
  TASK_PRIORITISED("task.prioritised"),
  TASK_RESUMED("task.resumed"),
  TASK_RETASKED("task.retasked"),
  TASK_ROBOT_BACK("task.robot-back"),
  TASK_ROBOT_CHARGES("task.robot-charges"),
  TASK_ROBOT_FAILED("task.robot-failed"),
  TASK_ROBOT_LOST("task.robot-lost"),
  TASK_ROBOT_WITHDRAWN("task.robot-withdrawn"),
  TASK_SET_DOWN("task.set-down"),
  TASK_STARTED("task.started"),
  TASK_WEIGHED("task.weighed"),
  TASK_ARM_FAILED("task.arm-failed"),
  ROBOT_ADDED("robot.added"),
  ROBOT_CHANGED("robot.changed"),
  ROBOT_CHARGE_ENDED("robot.charge-ended"),
  ROBOT_CHARGED("robot.charged"),
  ROBOT_CHARGER_FAILS("robot.charger-fails"),
  ROBOT_CHARGER_WORKS("robot.charger-works"),
  ROBOT_CHARGING("robot.charging"),
  ROBOT_HELD("robot.held"),
  ROBOT_IN_SERVICE("robot.in-service"),
  ROBOT_LINK_REFUSED("robot.link-refused"),
  ROBOT_LOCATED("robot.located"),
  ROBOT_OUT_OF_SERVICE("robot.out-of-service"),
  ROBOT_MANUAL_BEGAN("robot.manual-began"),
  ROBOT_MANUAL_ENDED("robot.manual-ended"),
  ROBOT_MOVED("robot.moved"),
  ROBOT_MQTT_PASSWORD("robot.mqtt-password"),
  ROBOT_PAIRED("robot.paired"),
  ROBOT_PAIRING_REFUSED("robot.pairing-refused"),
  ROBOT_REMOVED("robot.removed"),
  ROBOT_RESUMED("robot.resumed"),
  ROBOT_SENDS_NORMALLY("robot.sends-normally"),
  ROBOT_SENDS_TOO_MUCH("robot.sends-too-much"),
  ROBOT_SENT_HOME("robot.sent-home"),
  ROBOT_STOP_CLEARED("robot.stop-cleared"),
  ROBOT_STOP_NOT_CLEARED("robot.stop-not-cleared"),
  ROBOT_CONNECTION_REFUSED("robot.stranger"),
  ROBOT_TO_CHARGER("robot.to-charger"),
  ROBOT_WAITS_FOR_CHARGER("robot.waits-for-charger"),
  TRAFFIC_CUT_OFF("traffic.cut-off"),
  TRAFFIC_RESOLVED("traffic.resolved"),
  TRAFFIC_STANDSTILL("traffic.standstill"),
  FLOOR_ADDED("floor.added"),
  FLOOR_ALLOCATOR("floor.allocator"),
  FLOOR_HELD("floor.held"),
  FLOOR_MAP_PUBLISHED("floor.map-published"),
  FLOOR_OBSTACLE("floor.obstacle"),
  FLOOR_OBSTACLE_DOUBTED("floor.obstacle-doubted"),
  FLOOR_OBSTACLE_GONE("floor.obstacle-gone"),
  FLOOR_REMOVED("floor.removed"),
  FLOOR_RESUMED("floor.resumed"),
  FLEET_PAUSED("fleet.paused"),
  FLEET_RESUMED("fleet.resumed"),
  FLEET_SERVER_ENDED("fleet.server-ended"),
  FLEET_SERVER_STARTED("fleet.server-started"),
  FLEET_SERVER_STOPPED("fleet.server-stopped"),
  FLEET_DATABASE_AWAY("fleet.database-away"),
  FLEET_DATABASE_BACK("fleet.database-back"),
  SCHEDULE_ADDED("schedule.added"),
  SCHEDULE_BEGAN("schedule.began"),
  SCHEDULE_DELETED("schedule.deleted"),
  SCHEDULE_HANDED_OVER("schedule.handed-over"),
  SCHEDULE_PAUSED("schedule.paused"),
  SCHEDULE_REFUSED("schedule.refused"),
  SCHEDULE_RESUMED("schedule.resumed"),
  SCHEDULE_SKIPPED("schedule.skipped"),
  TEMPLATE_ADDED("template.added"),
  TEMPLATE_CHANGED("template.changed"),
  TEMPLATE_DELETED("template.deleted"),
  NOTICE_WEBHOOK_ADDED("notice.webhook-added"),
  NOTICE_WEBHOOK_CHANGED("notice.webhook-changed"),
  NOTICE_WEBHOOK_DELETED("notice.webhook-deleted"),
  NOTICE_WEBHOOK_SECRET("notice.webhook-secret"),
  NETWORK_DEVICE_ADDED("network.device-added"),
  NETWORK_DEVICE_CHANGED("network.device-changed"),
  NETWORK_DEVICE_REMOVED("network.device-removed"),
  CAMERA_ADDED("camera.added"),
  CAMERA_CHANGED("camera.changed"),
  CAMERA_REMOVED("camera.removed"),
  SUPERVISION_BEGAN("supervision.began"),
  SUPERVISION_DONE("supervision.done"),
  SUPERVISION_STOPPED("supervision.stopped"),
  SUPERVISION_LOOKS_AGAIN("supervision.looks-again"),
  SUPERVISION_BOX_LEFT_OUT("supervision.box-left-out"),
  EXPLORATION_BEGAN("exploration.began"),
  EXPLORATION_ENDED("exploration.ended"),
  EXPLORATION_STOPPED("exploration.stopped"),
  EXPLORATION_FAILED("exploration.failed"),
  SITE_ADDED("site.added"),
  SITE_REMOVED("site.removed"),
  USER_ADDED("user.added"),
  USER_CHANGED("user.changed"),
  USER_DELETED("user.deleted"),
  USER_PASSWORD("user.password"),
  USER_RESET("user.reset"),
  USER_SESSION("user.session"),
  USER_TOKEN("user.token");

  private final String text;

  EventKind(String text) {
    this.text = text;
  }

  /** As it is stored, and told by the API. */
  public String text() {
    return text;
  }

  /** Whether there are events of that kind, or of that family of kinds, such as {@code task}. */
  public static boolean isKnown(String kind) {
    return Arrays.stream(values())
        .anyMatch(each -> each.text.equals(kind) || each.text.startsWith(kind + "."));
  }

  /** What the history calls such an event of a mission. */
  static EventKind of(MissionEvent event) {
    return switch (event) {
      case MissionEvent.DriveStarted ignored -> TASK_STARTED;
      case MissionEvent.PhaseEnded e ->
          switch (e.phase()) {
            case TO_OBJECT -> TASK_AT_OBJECT;
            case TO_GOAL -> TASK_DELIVERED;
            case HOME, NONE -> TASK_PARKED;
          };
      case MissionEvent.Retasked ignored -> TASK_RETASKED;
      case MissionEvent.Exchanged ignored -> TASK_EXCHANGED;
      case MissionEvent.Stopped ignored -> TASK_SET_DOWN;
      case MissionEvent.ActFailed ignored -> TASK_ARM_FAILED;
      case MissionEvent.RobotLost ignored -> TASK_ROBOT_LOST;
      case MissionEvent.RobotFailed ignored -> TASK_ROBOT_FAILED;
      case MissionEvent.RobotWithdrawn ignored -> TASK_ROBOT_WITHDRAWN;
      case MissionEvent.ChargingRequired ignored -> TASK_ROBOT_CHARGES;
      case MissionEvent.RobotRecovered ignored -> TASK_ROBOT_BACK;
      case MissionEvent.Cancel ignored -> TASK_CANCELLED;
      case MissionEvent.Hold ignored -> TASK_HELD;
      case MissionEvent.Resume ignored -> TASK_RESUMED;
      case MissionEvent.Prioritise ignored -> TASK_PRIORITISED;
      case MissionEvent.Edit ignored -> TASK_EDITED;
      case MissionEvent.Answer ignored -> TASK_ANSWERED;
      case MissionEvent.HandOver ignored -> TASK_HANDED_OVER;
      case MissionEvent.GoOn ignored -> TASK_WENT_ON;
      case MissionEvent.WaitEnded ignored -> TASK_WENT_ON;
      case MissionEvent.ChargeEnded ignored -> TASK_WENT_ON;
      case MissionEvent.LoadFetched ignored -> TASK_LOAD_FETCHED;
      case MissionEvent.MoveLoad ignored -> TASK_LOAD_MOVED;
      case MissionEvent.RemoveLoad ignored -> TASK_LOAD_REMOVED;
    };
  }
}
