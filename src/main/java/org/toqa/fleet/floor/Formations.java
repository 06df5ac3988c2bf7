package org.toqa.fleet.floor;

import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.TeamSize;
import org.toqa.arm.Arm;
import org.toqa.arm.ArmStance;
import org.toqa.fleet.FloorView.HeldLoad;
import org.toqa.fleet.FloorView.HoldPoint;
import org.toqa.fleet.RobotCapabilities;
import org.toqa.fleet.robot.RobotMessage;
import org.toqa.formation.GroupMobility;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.link.message.ServerMessage.CarriedPart;
import org.toqa.link.message.ServerMessage.Follower;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Phase;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.motion.DriveSpeeds;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * The floor's groups: missions with several robots, the first of which leads. While they carry, the
 * traffic knows the leader alone, with the whole group's cells; the followers are no robots of it.
 */
final class Formations {
  /** Metres by which a group that picks up a load may take itself to be beside its place. */
  private static final double AT_OBJECT = 0.25;

  private final FloorState state;
  private final FormationPlacement places;
  private final Map<Key, Optional<Formation>> formations = new HashMap<>();

  /** What a formation is made of. */
  private record Key(long task, Vec2 object, List<Vec2> stops, List<String> robots) {}

  Formations(FloorState state) {
    this.state = state;
    this.places = new FormationPlacement(state.floor.grid(), state.floor.margins());
  }

  /** Empty for a mission of one robot, and where there is no room round the load. */
  Optional<Formation> of(Mission mission) {
    if (mission.assignedRobots().size() < 2) {
      return Optional.empty();
    }
    List<String> robots = mission.assignedRobots().stream().map(AssignedRobot::robot).toList();
    Vec2 object = mission.object().position();
    List<Vec2> stops = mission.placesFromObject().stream().map(TaskPlace::position).toList();
    return formations.computeIfAbsent(
        new Key(mission.id(), object, stops, robots),
        key ->
            places.find(
                object,
                stops,
                robots.size(),
                mission.task().size(),
                largestRadius(mission),
                mobility(mission)));
  }

  private GroupMobility mobility(Mission mission) {
    return mission.assignedRobots().stream()
        .map(assigned -> state.robots.get(assigned.robot()))
        .filter(Objects::nonNull)
        .map(robot -> robot.reported.capabilities().mobility())
        .max(Comparator.naturalOrder())
        .orElse(GroupMobility.SHIFTING);
  }

  private double largestRadius(Mission mission) {
    return mission.assignedRobots().stream()
            .map(c -> state.robots.get(c.robot()))
            .filter(Objects::nonNull)
            .mapToDouble(r -> r.reported.footprint())
            .max()
            .orElse(RobotCapabilities.UNKNOWN.footprint())
        / 2;
  }

  /** What the robot's phase of the mission asks. */
  DriveGoal driveGoal(Mission mission, String robot) {
    DriveGoal ordered =
        DriveGoal.of(mission, robot, state.parkingPoint(robot), share(mission, robot));
    DriveGoal goal = chosenCharger(mission, robot).map(ordered::leadingTo).orElse(ordered);
    Optional<Double> facing = headingOfArm(mission, robot, goal.goal());
    if (facing.isPresent()) {
      return goal.facing(facing.get());
    }
    Optional<Formation> formation = of(mission);
    if (goal.phase() != Phase.TO_OBJECT || formation.isEmpty()) {
      return goal;
    }
    Pose place = formation.get().pose(index(mission, robot));
    return new DriveGoal(
        goal.task(), Phase.TO_OBJECT, place.position(), place.theta(), 0, 0, false);
  }

  /** Where the robot has its turn to charge for the mission. */
  private Optional<Vec2> chosenCharger(Mission mission, String robot) {
    FloorRobot known = state.robots.get(robot);
    return known == null || mission.chargingStop().isEmpty()
        ? Optional.empty()
        : known.charging.turn().flatMap(turn -> state.chargingPoint(turn.point()));
  }

  /** How the robot faces at its goal for its arm; empty where that has nothing to do there. */
  private Optional<Double> headingOfArm(Mission mission, String robot, Vec2 goal) {
    FloorRobot known = state.robots.get(robot);
    Arm arm = known == null ? null : known.reported.capabilities().arm();
    return arm == null
        ? Optional.empty()
        : mission
            .armTask(robot)
            .flatMap(
                task ->
                    ArmStance.find(arm, goal, task.target()) instanceof ArmStance.Facing facing
                        ? Optional.of(facing.heading())
                        : Optional.empty());
  }

  /** Kilograms that the robot has of the mission's load. */
  double share(Mission mission, String robot) {
    if (mission.assignedRobots().size() < 2) {
      return mission.task().load();
    }
    List<String> team = mission.assignedRobots().stream().map(AssignedRobot::robot).toList();
    int index = team.indexOf(robot);
    if (index < 0) {
      return mission.task().load();
    }
    return TeamSize.shares(mission.task().load(), team.stream().map(this::maxLoad).toList())
        .get(index);
  }

  /** Where the robots of a group hold its load, until that is delivered. */
  Optional<HeldLoad> heldLoad(Mission mission) {
    if (!isGroup(mission) || mission.state() == TaskState.RETURNING) {
      return Optional.empty();
    }
    List<String> team = mission.assignedRobots().stream().map(AssignedRobot::robot).toList();
    List<Double> shares = team.stream().map(robot -> share(mission, robot)).toList();
    return of(mission)
        .flatMap(
            formation ->
                formation.holds(shares).map(points -> held(mission, formation, points, shares)));
  }

  private HeldLoad held(
      Mission mission, Formation formation, List<Vec2> points, List<Double> shares) {
    List<String> team = mission.assignedRobots().stream().map(AssignedRobot::robot).toList();
    return new HeldLoad(
        mission.id(),
        IntStream.range(0, team.size())
            .mapToObj(
                i ->
                    new HoldPoint(
                        team.get(i),
                        points.get(i),
                        formation.place(i),
                        shares.get(i),
                        measuredShare(mission, team.get(i))))
            .toList());
  }

  /** Kilograms, in tenths; null where the robot carries nothing yet, or cannot say. */
  private @Nullable Double measuredShare(Mission mission, String robot) {
    FloorRobot known = state.robots.get(robot);
    Double measured = known == null ? null : known.reported.report().readings().measuredLoad();
    return measured == null || mission.state() != TaskState.CARRYING
        ? null
        : Double.valueOf(Math.round(10 * measured) / 10.0);
  }

  private double maxLoad(String robot) {
    FloorRobot known = state.robots.get(robot);
    return known == null
        ? 1
        : Math.max(Double.MIN_NORMAL, known.reported.capabilities().allowedLoad(known.record()));
  }

  private static int index(Mission mission, String robot) {
    return mission.assignedRobots().stream().map(AssignedRobot::robot).toList().indexOf(robot);
  }

  static boolean isGroup(Mission mission) {
    return mission.assignedRobots().size() > 1;
  }

  /**
   * Why a robot of a group is sent nowhere, to the load or with it: the group has no places round
   * the load, as on a map that was changed since. Null: it has, or is none.
   */
  @Nullable Sentence objection(String robot) {
    return state
        .missions
        .missionOf(robot)
        .filter(m -> isGroup(m) && of(m).isEmpty())
        .filter(m -> m.assignedRobot(robot).filter(c -> c.phase() != Phase.HOME).isPresent())
        .map(m -> TeamRoomCheck.objection(m, m.assignedRobots().size()))
        .orElse(null);
  }

  static String leader(Mission mission) {
    return mission.assignedRobots().getFirst().robot();
  }

  /** The mission that the robot carries a load for, together with others. */
  Optional<Mission> carryingMission(String robot) {
    return state
        .missions
        .missionOf(robot)
        .filter(m -> isGroup(m) && m.state() == TaskState.CARRYING && of(m).isPresent());
  }

  /** The mission in which the robot follows another one now. */
  Optional<Mission> followedMission(String robot) {
    return carryingMission(robot).filter(m -> !leader(m).equals(robot));
  }

  /** The formation that this robot leads now, its followers at their places or driving there. */
  Optional<Formation> ledFormation(String robot) {
    return carryingMission(robot)
        .filter(m -> leader(m).equals(robot) && isTogether(m))
        .flatMap(this::of);
  }

  /** Whether the group's cells are its leader's, so that this one has none of its own. */
  boolean isCoveredByLeader(String robot) {
    return followedMission(robot)
        .filter(this::isTogether)
        .map(m -> state.robots.get(leader(m)))
        .filter(leader -> leader.reported.pose() != null)
        .isPresent();
  }

  private boolean isTogether(Mission mission) {
    FloorRobot leader = state.robots.get(leader(mission));
    return leader != null
        && leader.reported.report().at() != null
        && (leader.reported.report().role() == Role.LEADER || isFollowedByAll(mission));
  }

  /** Whether every follower was told its place and says that it keeps it. */
  boolean isFollowedByAll(Mission mission) {
    return notFollowing(mission).isEmpty();
  }

  /** The followers that do not say so, by name. */
  List<String> notFollowing(Mission mission) {
    return mission.assignedRobots().stream()
        .skip(1)
        .map(AssignedRobot::robot)
        .filter(
            name -> {
              FloorRobot robot = state.robots.get(name);
              return robot == null || !isFollowing(robot, mission);
            })
        .toList();
  }

  /**
   * Whether the robot leads and stands for its followers, of whom the server hears that all follow
   * and nothing keeps them: it seeks one where that is no more, as after an address has changed.
   */
  boolean isSeparated(FloorRobot leader) {
    LastReport report = leader.reported.report();
    return report.role() == Role.LEADER
        && report.hasError(LastReport.FORMATION_STOPPED)
        && !report.moving()
        && !leader.hold.isHeld()
        && carryingMission(leader.name()).filter(this::isFollowedFreely).isPresent();
  }

  private boolean isFollowedFreely(Mission mission) {
    return isFollowedByAll(mission)
        && mission.assignedRobots().stream()
            .skip(1)
            .map(assigned -> state.robots.get(assigned.robot()))
            .filter(Objects::nonNull)
            .allMatch(
                robot ->
                    robot.isHeard()
                        && !robot.hold.isHeld()
                        && !robot.reported.report().hasErrorBut(LastReport.LEADER_LOST));
  }

  static boolean isFollowing(FloorRobot robot, Mission mission) {
    LastReport report = robot.reported.report();
    return report.role() == Role.FOLLOWER
        && Objects.equals(report.task(), mission.id())
        && report.drive() != 0;
  }

  /** Lets the traffic know groups that carry, and again each robot of those that do not. */
  void updateTraffic() {
    formations.keySet().removeIf(key -> state.missions.get(key.task()).isEmpty());
    for (FloorRobot robot : state.robots.values()) {
      LastReport report = robot.reported.report();
      Pose pose = report.pose();
      if (pose == null || report.at() == null) {
        continue;
      }
      if (isCoveredByLeader(robot.name())) {
        if (state.traffic.hasRobot(robot.name())) {
          state.traffic.removeRobot(robot.name());
        }
      } else if (!state.traffic.hasRobot(robot.name()) && report.role() == Role.FOLLOWER) {
        state.traffic.reportStanding(robot.name(), pose, state.diameter(robot), state.now);
      }
      if (state.traffic.hasRobot(robot.name())) {
        Optional<Formation> led = ledFormation(robot.name());
        state.traffic.setSpeeds(robot.name(), led.isPresent() ? groupSpeeds(robot) : speeds(robot));
        state.traffic.setFormation(robot.name(), led.map(Formation::group).orElse(null));
      }
    }
  }

  private static DriveSpeeds speeds(FloorRobot robot) {
    return robot.reported.capabilities().speeds();
  }

  /** What every robot of the group that this one leads can do. */
  private DriveSpeeds groupSpeeds(FloorRobot leader) {
    DriveSpeeds slowest =
        carryingMission(leader.name()).stream()
            .flatMap(mission -> mission.assignedRobots().stream())
            .map(assigned -> state.robots.get(assigned.robot()))
            .filter(Objects::nonNull)
            .map(Formations::speeds)
            .reduce(speeds(leader), DriveSpeeds::slower);
    double most =
        ledFormation(leader.name())
            .map(formation -> formation.shape().law().mostSpeed())
            .orElse(Double.POSITIVE_INFINITY);
    return slowest.atMost(most, Double.POSITIVE_INFINITY);
  }

  /** The order for a follower. */
  RobotMessage.Follow followOrder(Mission mission, FloorRobot robot) {
    Formation formation = of(mission).orElseThrow();
    FloorRobot leader = state.robots.get(leader(mission));
    return new RobotMessage.Follow(
        mission.id(),
        leader(mission),
        leader == null ? null : leader.fingerprint(),
        formation.offset(index(mission, robot.name())),
        formation.tolerance(),
        carriedPart(mission, robot.name()),
        Objects.requireNonNull(robot.reported.pose()));
  }

  /** The order for the leader. */
  RobotMessage.Lead leadOrder(Mission mission) {
    List<Follower> followers =
        mission.assignedRobots().stream()
            .skip(1)
            .map(c -> state.robots.get(c.robot()))
            .filter(Objects::nonNull)
            .map(r -> new Follower(r.name(), r.record().host(), r.record().port(), r.fingerprint()))
            .toList();
    return new RobotMessage.Lead(
        mission.id(),
        of(mission).orElseThrow().tolerance(),
        followers,
        carriedPart(mission, leader(mission)));
  }

  /** What the robot has of the load, and where; null where the robots cannot hold it so. */
  private @Nullable CarriedPart carriedPart(Mission mission, String robot) {
    List<String> team = mission.assignedRobots().stream().map(AssignedRobot::robot).toList();
    List<Double> shares = team.stream().map(member -> share(mission, member)).toList();
    int index = team.indexOf(robot);
    return of(mission)
        .flatMap(formation -> formation.holdFrom(index, shares))
        .map(
            point ->
                new CarriedPart(
                    shares.get(index), mission.task().load(), point, loadMiddle(mission)))
        .orElse(null);
  }

  /** Where the load is picked up, or where robots are with it that were interrupted. */
  private Vec2 loadMiddle(Mission mission) {
    Vec2 object = mission.object().position();
    Pose onBoard = loadPose(mission);
    return onBoard == null || onBoard.position().distanceTo(object) < AT_OBJECT
        ? object
        : onBoard.position();
  }

  /** Where the load of a group is while it is on board; null where nobody knows. */
  @Nullable Pose loadPose(Mission mission) {
    FloorRobot leader = state.robots.get(leader(mission));
    Pose pose = leader == null ? null : leader.reported.pose();
    return pose == null ? null : of(mission).map(f -> f.shape().loadAt(pose)).orElse(null);
  }

  /** Where a robot's load is: under it, or in the midst of its group. */
  @Nullable TaskPlace loadPlace(Mission mission, FloorRobot robot) {
    Pose load =
        isGroup(mission) && mission.state() == TaskState.CARRYING
            ? loadPose(mission)
            : robot.reported.pose();
    return load == null ? null : new TaskPlace(load.position(), null);
  }

  /** Whether the robot, which says so, has ended its phase where that ends. */
  boolean isAtGoal(Mission mission, FloorRobot robot) {
    if (isGroup(mission) && mission.state() == TaskState.CARRYING) {
      Pose load = loadPose(mission);
      return load != null
          && load.position().distanceTo(mission.destination().position())
              < FloorState.ARRIVAL_DISTANCE;
    }
    return state.isAt(robot, driveGoal(mission, robot.name()).goal());
  }

  /**
   * Whether all others of the group that this one completes at the load stand at their places: who
   * came before may have made room for another robot since, and is on its way back.
   */
  boolean areOthersInPlace(Mission mission, String last) {
    List<AssignedRobot> others =
        mission.assignedRobots().stream().filter(c -> !c.robot().equals(last)).toList();
    return others.stream().anyMatch(AssignedRobot::isDriving)
        || others.stream()
            .filter(c -> !c.unassigned())
            .map(c -> state.robots.get(c.robot()))
            .filter(Objects::nonNull)
            .allMatch(r -> r.isStanding() && isAtGoal(mission, r));
  }

  /** Whether some robot of the mission still moves. */
  boolean isMoving(Mission mission) {
    return mission.assignedRobots().stream()
        .map(c -> state.robots.get(c.robot()))
        .anyMatch(r -> r != null && r.isHeard() && r.reported.isMoving());
  }

  /** What is known of the load that the mission has on board, if it has. */
  MissionEvent.LoadState loadState(Mission mission) {
    List<FloorRobot> robots =
        mission.assignedRobots().stream()
            .map(c -> state.robots.get(c.robot()))
            .filter(Objects::nonNull)
            .toList();
    Set<String> driving =
        robots.stream()
            .filter(FloorRobot::isHeard)
            .filter(r -> r.reported.isMoving() || (r.isFit() && !r.hasStopped()))
            .map(FloorRobot::name)
            .collect(Collectors.toSet());
    return new MissionEvent.LoadState(
        robots.isEmpty() ? null : loadPlace(mission, robots.getFirst()), driving);
  }

  /**
   * Why the whole group shall stop before it is told otherwise; null: it need not. Robots that are
   * stopped one by one would tear at the load.
   */
  @Nullable Sentence stopReason(Mission mission) {
    if (!isGroup(mission) || mission.state() != TaskState.CARRYING) {
      return null;
    }
    if (mission.isStopping()) {
      return Phrase.STOPS_TO_SET_DOWN.with(mission.id());
    }
    FloorRobot leader = state.robots.get(leader(mission));
    return leader != null && isDrivingElsewhere(leader, mission)
        ? Phrase.STOPS_TO_GO_ELSEWHERE.with()
        : null;
  }

  /** Whether it drives for the mission, but not where that leads now. */
  private static boolean isDrivingElsewhere(FloorRobot leader, Mission mission) {
    Vec2 goal = leader.drive.order().knownGoal();
    LastReport report = leader.reported.report();
    return goal != null
        && report.drive() != 0
        && Objects.equals(report.task(), mission.id())
        && !goal.equals(mission.destination().position());
  }
}
