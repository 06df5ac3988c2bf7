package org.toqa.fleet.dispatch;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.toqa.arm.Arm;
import org.toqa.arm.ArmStance;
import org.toqa.arm.Reach;
import org.toqa.fleet.Answer;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Vec2;
import org.toqa.mission.ArmHandling;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Which robots' arms can do what a task asks of them: robots may face as they like where they
 * stand.
 *
 * @param robots those of the floor that have arms
 */
record ArmReach(List<Armed> robots) {

  /**
   * @param maxLoad kilograms that robot and arm carry
   */
  record Armed(String robot, Arm arm, double maxLoad) {}

  static ArmReach of(List<RobotView> floor) {
    return new ArmReach(
        floor.stream()
            .flatMap(
                robot ->
                    Stream.ofNullable(robot.capabilities().arm())
                        .map(
                            arm ->
                                new Armed(
                                    robot.name(), arm, Math.min(arm.maxLoad(), robot.maxLoad()))))
            .toList());
  }

  /** The robots that can do it. */
  Set<String> able(TransportTask task, ArmHandling handling) {
    return robots.stream()
        .filter(robot -> robot.maxLoad() >= task.load())
        .filter(robot -> reaches(robot, task.start(), handling.pick()))
        .filter(robot -> reaches(robot, task.goal(), handling.place()))
        .map(Armed::robot)
        .collect(Collectors.toSet());
  }

  private static boolean reaches(Armed robot, TaskPlace stand, Vec2 target) {
    return ArmStance.find(robot.arm(), stand.position(), target) instanceof ArmStance.Facing;
  }

  /** What speaks against the task, with the fields of the order; empty: some robot can do it. */
  <T> List<Answer.Rejected<T>> objections(TransportTask task) {
    ArmHandling handling = task.arm();
    if (handling == null || !able(task, handling).isEmpty()) {
      return List.of();
    }
    if (robots.isEmpty()) {
      return List.of(new Answer.Rejected<>("arm", Phrase.NO_ARM_HERE.with()));
    }
    List<Armed> strong = robots.stream().filter(robot -> robot.maxLoad() >= task.load()).toList();
    if (strong.isEmpty()) {
      double most = robots.stream().mapToDouble(Armed::maxLoad).max().orElse(0);
      return List.of(new Answer.Rejected<>("load", Phrase.ARM_CANNOT_LIFT.with(task.load(), most)));
    }
    List<Answer.Rejected<T>> rejections =
        Stream.concat(
                ArmReach.<T>objection("arm.pick", strong, task.start(), handling.pick()).stream(),
                ArmReach.<T>objection("arm.place", strong, task.goal(), handling.place()).stream())
            .toList();
    return rejections.isEmpty()
        ? List.of(new Answer.Rejected<>("arm", Phrase.NO_ARM_FOR_BOTH.with()))
        : rejections;
  }

  private static <T> Optional<Answer.Rejected<T>> objection(
      String field, List<Armed> robots, TaskPlace stand, Vec2 target) {
    return robots.stream().anyMatch(robot -> reaches(robot, stand, target))
        ? Optional.empty()
        : robots.stream()
            .max(Comparator.comparingDouble(robot -> robot.arm().farthest()))
            .map(
                robot ->
                    new Answer.Rejected<>(
                        field,
                        Phrase.ARM_OUT_OF_REACH.with(
                            stand.sentence(),
                            Sentence.of(target),
                            reason(robot.arm(), stand.position(), target))));
  }

  private static Sentence reason(Arm arm, Vec2 stand, Vec2 target) {
    if (!(ArmStance.find(arm, stand, target)
        instanceof ArmStance.None(Reach.Reason reason, double distance))) {
      throw new IllegalArgumentException("it is within reach");
    }
    return switch (reason) {
      case TOO_FAR -> Phrase.REACH_TOO_FAR.with(distance, arm.farthest());
      case TOO_NEAR -> Phrase.REACH_TOO_NEAR.with(distance, arm.nearest());
      case JOINT_LIMITS -> Phrase.REACH_JOINT_LIMITS.with();
    };
  }
}
