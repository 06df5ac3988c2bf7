package org.toqa.fleet.dispatch;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import org.toqa.allocation.AllocationProblem;
import org.toqa.allocation.Candidate;
import org.toqa.allocation.Decision;
import org.toqa.allocation.TeamSize;
import org.toqa.fleet.TaskPreview;
import org.toqa.fleet.floor.PlaceCheck;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.mission.Mission;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Sentence;

/**
 * Tells what would become of a task that nobody has asked for yet. Any thread may ask; nothing is
 * computed on the asking one.
 */
final class TaskPreviewer {
  private final RoundDecider decider;
  private final PathQuery paths;
  private final FloorMap floor;
  private final OrderChecks.Check check;

  /**
   * @param floor the task's
   * @param check of the preview
   */
  TaskPreviewer(RoundDecider decider, PathQuery paths, FloorMap floor, OrderChecks.Check check) {
    this.decider = decider;
    this.paths = paths;
    this.floor = floor;
    this.check = check;
  }

  /**
   * @param problem of the floor, where this task is the only one that waits
   * @param now of the time that ticks bring
   */
  CompletableFuture<TaskPreview> preview(
      TransportTask task, AllocationProblem problem, Instant now) {
    return preview(task, problem, RoomLimits.NONE, now);
  }

  private CompletableFuture<TaskPreview> preview(
      TransportTask task, AllocationProblem problem, RoomLimits room, Instant now) {
    return check
        .run(() -> new Inquiry(decider.inquire(problem, Runnable::run, now)))
        .thenCompose(Inquiry::decision)
        .thenCompose(decision -> preview(task, problem, decision, room, now));
  }

  /**
   * @param decision once robots have answered, where they are asked
   */
  private record Inquiry(CompletableFuture<Decision> decision) {}

  private CompletableFuture<TaskPreview> preview(
      TransportTask task,
      AllocationProblem problem,
      Decision decision,
      RoomLimits room,
      Instant now) {
    List<String> chosen = chosen(decision);
    List<Candidate> team =
        problem.robots().stream().filter(r -> chosen.contains(r.robot())).toList();
    return objection(task, problem, team)
        .thenCompose(
            noRoom -> {
              RoomLimits others =
                  room.without(PathQuery.TeamQuestion.of(Mission.queued(task), team));
              return noRoom
                  .filter(_ -> team.size() > 1)
                  .flatMap(_ -> others.restrict(problem.waiting().getFirst(), problem.robots()))
                  .map(job -> preview(task, problem.withTask(job), others, now))
                  .orElseGet(() -> preview(task, problem, decision, noRoom));
            });
  }

  private CompletableFuture<TaskPreview> preview(
      TransportTask task, AllocationProblem problem, Decision decision, Optional<Sentence> noRoom) {
    List<String> chosen = chosen(decision);
    int robots =
        chosen.isEmpty()
            ? TeamSize.smallest(task.load(), allowed(task, problem)).orElse(0)
            : chosen.size();
    return path(task, chosenOf(chosen, problem))
        .thenApply(
            path ->
                noRoom
                    .map(objection -> new TaskPreview(robots, List.of(), objection, path))
                    .orElseGet(() -> new TaskPreview(robots, chosen, decision.reason(), path)));
  }

  private static List<Candidate> allowed(TransportTask task, AllocationProblem problem) {
    return problem.robots().stream().filter(robot -> task.allows(robot.robot())).toList();
  }

  /** Where nobody is chosen yet, to the narrowest that there are. */
  private CompletableFuture<Optional<Sentence>> objection(
      TransportTask task, AllocationProblem problem, List<Candidate> team) {
    return paths.objectionToTeams(
        floor,
        Mission.queued(task),
        team.isEmpty() ? Capacity.narrowestTeams(task, problem.robots()) : List.of(team),
        check);
  }

  private static List<String> chosen(Decision decision) {
    return switch (decision) {
      case Decision.Assigned assigned -> assigned.robots();
      case Decision.Unassigned _ -> List.of();
    };
  }

  private static Stream<Candidate> chosenOf(List<String> chosen, AllocationProblem problem) {
    return problem.robots().stream().filter(robot -> chosen.contains(robot.robot()));
  }

  /** Along all its stops; of a drive from where its robot is. */
  private CompletableFuture<List<Vec2>> path(TransportTask task, Stream<Candidate> team) {
    List<Vec2> places =
        Stream.concat(
                team.filter(_ -> task.isDrive()).map(Candidate::position),
                task.placesFrom(0).stream().map(TaskPlace::position))
            .toList();
    CompletableFuture<List<Vec2>> points = CompletableFuture.completedFuture(List.of());
    for (int i = 1; i < places.size(); i++) {
      Vec2 from = places.get(i - 1);
      Vec2 to = places.get(i);
      points =
          points.thenCompose(
              before ->
                  legPath(from, to)
                      .thenApply(next -> Stream.concat(before.stream(), next.stream()).toList()));
    }
    return points;
  }

  private CompletableFuture<List<Vec2>> legPath(Vec2 from, Vec2 to) {
    return paths
        .findPath(floor.grid(), from, to, 2 * PlaceCheck.SMALLEST_RADIUS, check)
        .thenApply(
            path ->
                switch (path) {
                  case FloorPath.Found(List<Vec2> points) -> points;
                  case FloorPath.FoundBetweenCells _, FloorPath.NotFound _ -> List.of();
                });
  }
}
