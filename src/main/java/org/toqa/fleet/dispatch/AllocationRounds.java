package org.toqa.fleet.dispatch;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.apache.pekko.actor.typed.ActorRef;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.allocation.AllocationProblem;
import org.toqa.allocation.AllocationProblem.GivenTask;
import org.toqa.allocation.AllocationTask;
import org.toqa.allocation.Availability;
import org.toqa.allocation.Candidate;
import org.toqa.allocation.Decision;
import org.toqa.allocation.PlaceUse;
import org.toqa.allocation.Terrain;
import org.toqa.allocation.WaitExplainer;
import org.toqa.fleet.NegotiationEntry;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.floor.FloorMessage;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.mission.ArmHandling;
import org.toqa.mission.Mission;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Sentence;

/**
 * Lets the allocator decide who carries what, and hands tasks over.
 *
 * <p>A round is computed on another thread from immutable values: who carries what, and whether the
 * teams have room. Of what it says that is adopted which still fits the tasks and robots as they
 * are then; the next round is asked about the rest.
 */
final class AllocationRounds {
  private static final Logger log = LoggerFactory.getLogger(AllocationRounds.class);

  /** Whoever has not answered in a round may do so in one that is so much later. */
  private static final Duration NEXT_ROUND = Duration.ofSeconds(5);

  private final DispatchState state;
  private final RoundDecider decider;
  private final PathQuery paths;
  private final ActorRef<DispatchMessage> self;
  private final TaskExchanges exchanges = new TaskExchanges();

  /** What robots were last seen to be kept by. */
  private Map<String, Availability> availabilities = Map.of();

  /** Which places were last seen to be in use. */
  private List<PlaceUse> placesSeen = List.of();

  /** By task: what the last round said of those that wait. */
  private Map<Long, Sentence> reasons = new HashMap<>();

  private final RoomFindings rooms = new RoomFindings();

  private boolean isDeciding;

  /** When the next round is due, where the last one was not answered by all; else null. */
  private @Nullable Instant nextRound;

  private final NegotiationLines negotiations = new NegotiationLines();

  /** Tasks of the running round of which something else was ordered since it began. */
  private final Set<Long> editedInRound = new HashSet<>();

  AllocationRounds(
      DispatchState state, RoundDecider decider, PathQuery paths, ActorRef<DispatchMessage> self) {
    this.state = state;
    this.decider = decider;
    this.paths = paths;
    this.self = self;
  }

  /**
   * Nothing counts that was found for what was ordered before.
   *
   * @param before the task as it was
   */
  void taskEdited(TransportTask before) {
    rooms.forget(before.id());
    reasons.remove(before.id());
    if (isDeciding) {
      editedInRound.add(before.id());
    }
  }

  /** The floor has told how it is: it is time for a round where robots or places became free. */
  void floorReported() {
    Map<String, Availability> now =
        state.candidates().stream()
            .collect(Collectors.toMap(Candidate::robot, Candidate::availability));
    List<PlaceUse> inUse = state.placesInUse();
    state.isRoundDue |= !now.equals(availabilities) || !inUse.equals(placesSeen);
    availabilities = now;
    placesSeen = inUse;
  }

  /** Lets the allocator decide, on a thread of its own, where it is time. */
  void beginDueRound() {
    retryTeams();
    if (nextRound != null && !state.now.isBefore(nextRound)) {
      nextRound = null;
      state.isRoundDue = true;
    }
    if (state.isRoundDue && state.report != null && !isDeciding) {
      state.isRoundDue = false;
      beginRound();
    }
  }

  /** What was said of them is said until the next round is over. */
  private void retryTeams() {
    rooms
        .takeDue(state.now)
        .forEach((task, why) -> state.queue.get(task).ifPresent(queued -> tryAgain(queued, why)));
  }

  private void tryAgain(TaskQueue.Queued queued, Sentence why) {
    reasons.put(queued.task().id(), why);
    state.isRoundDue = true;
  }

  private void beginRound() {
    FloorMap floor = state.floor;
    List<Candidate> robotsHere = state.candidates();
    List<GivenTask> given =
        exchanges.exchangeableTasks(state.assignedTasks(), state.robotsHere(), state.now);
    Strongest ofAll = Strongest.of(robotsHere, given, _ -> true);
    List<AllocationTask> jobs =
        state
            .queue
            .firstJobs(
                queued ->
                    state.legs.reasonToWait(queued.task()).isEmpty()
                        && !isWithoutArm(queued.task())
                        && isWorthAsking(
                            queued.task(),
                            queued.task().onlyRobots().isEmpty()
                                ? ofAll
                                : Strongest.of(
                                    robotsHere,
                                    given,
                                    state.chosen().named(queued.task())::allows)),
                DispatchState.TASKS_CONSIDERED)
            .stream()
            .map(this::restricted)
            .map(job -> rooms.restricted(job, robotsHere))
            .toList();
    if (jobs.isEmpty()) {
      reasons.clear();
      state.changed = true;
    }
    if (jobs.isEmpty() && given.isEmpty()) {
      return;
    }
    isDeciding = true;
    AllocationProblem problem = problem(jobs, given, robotsHere);
    Map<Long, Mission> missions =
        jobs.stream()
            .flatMap(job -> state.queue.get(job.id()).stream())
            .map(TaskQueue.Queued::mission)
            .collect(Collectors.toMap(Mission::id, mission -> mission));
    Executor executor = state.runtime.threadPerTaskExecutor("allocation-" + floor.name());
    var _ =
        decider
            .decide(problem, executor, state.now)
            .thenComposeAsync(round -> withTeams(floor, problem, missions, round), executor)
            .whenComplete(
                (decided, failure) -> self.tell(roundMessage(floor.name(), decided, failure)));
  }

  /**
   * Asks for room for the teams that came out.
   *
   * @param missions the problem's waiting tasks, by task
   */
  private CompletableFuture<DispatchMessage.AllocationDecided> withTeams(
      FloorMap floor, AllocationProblem problem, Map<Long, Mission> missions, DecidedRound round) {
    Map<Long, CompletableFuture<TeamFinding>> teams = new HashMap<>();
    for (Decision decision : round.decisions()) {
      if (decision instanceof Decision.Assigned(long id, List<String> chosen, Sentence _)) {
        Mission mission = missions.get(id);
        if (mission != null && chosen.size() > 1) {
          teams.put(id, teamFinding(floor, mission, team(problem.robots(), chosen)));
        }
      }
    }
    return CompletableFuture.allOf(teams.values().toArray(CompletableFuture[]::new))
        .thenApply(
            _ ->
                new DispatchMessage.AllocationDecided(
                    round,
                    teams.entrySet().stream()
                        .collect(
                            Collectors.toMap(Map.Entry::getKey, team -> team.getValue().join()))));
  }

  private CompletableFuture<TeamFinding> teamFinding(
      FloorMap floor, Mission mission, List<Candidate> team) {
    PathQuery.TeamQuestion question = PathQuery.TeamQuestion.of(mission, team);
    return paths
        .objectionToTeam(floor, mission, question)
        .thenApply(objection -> new TeamFinding(question, objection));
  }

  private static List<Candidate> team(List<Candidate> robots, List<String> chosen) {
    return robots.stream().filter(robot -> chosen.contains(robot.robot())).toList();
  }

  /**
   * What one of the robots carries that may have a task, kilograms.
   *
   * @param free the most of those that are free, or may be by an exchange; nothing while none is
   *     free
   * @param all the most of all, whatever they do
   */
  private record Strongest(double free, double all) {
    static Strongest of(List<Candidate> robots, List<GivenTask> given, Predicate<String> mayHave) {
      Set<String> holders = given.stream().map(GivenTask::robot).collect(Collectors.toSet());
      boolean isAnyFree = robots.stream().anyMatch(r -> r.availability() == Availability.FREE);
      return new Strongest(
          most(
              robots,
              r ->
                  isAnyFree
                      && mayHave.test(r.robot())
                      && (r.availability() == Availability.FREE || holders.contains(r.robot()))),
          most(robots, r -> mayHave.test(r.robot())));
    }

    private static double most(List<Candidate> robots, Predicate<Candidate> which) {
      return robots.stream()
          .filter(which)
          .mapToDouble(Candidate::maxLoad)
          .max()
          .orElse(Double.NEGATIVE_INFINITY);
    }
  }

  private boolean isWorthAsking(TransportTask task, Strongest strongest) {
    return task.load() <= strongest.free()
        || (strongest.free() > 0
            && task.load() > strongest.all()
            && !rooms.isWithoutRoom(task.id()));
  }

  /** Whether no robot is known whose arm reaches what the task asks: none is asked then. */
  private boolean isWithoutArm(TransportTask task) {
    return task.arm() != null
        && ArmReach.of(state.robotsHere()).able(task, task.arm()).stream()
            .noneMatch(state.chosen().named(task)::allows);
  }

  private AllocationTask restricted(AllocationTask job) {
    return state
        .queue
        .get(job.id())
        .map(TaskQueue.Queued::task)
        .map(task -> restricted(job, task))
        .orElse(job);
  }

  /**
   * For the robots that were chosen, by their names; where an arm picks the load up, only those
   * whose arms can.
   */
  AllocationTask restricted(AllocationTask job, TransportTask task) {
    ArmHandling arm = task.arm();
    return arm == null
        ? state.chosen().named(job)
        : job.withOnlyRobots(
                ArmReach.of(state.robotsHere()).able(task, arm).stream()
                    .filter(state.chosen().named(task)::allows)
                    .sorted()
                    .toList())
            .withStops(job.via(), true);
  }

  AllocationProblem problem(
      List<AllocationTask> jobs, List<GivenTask> given, List<Candidate> robotsHere) {
    OccupancyGrid grid = state.floor.grid();
    Vec2 size = new Vec2(grid.width(), grid.height()).times(grid.resolution());
    return new AllocationProblem(
        state.clock.instant(),
        grid.origin(),
        grid.origin().plus(size),
        new Terrain(state.distances, state.chargerPositions()),
        jobs,
        given,
        robotsHere,
        state.placesInUse());
  }

  private static DispatchMessage roundMessage(
      String floor,
      DispatchMessage.@Nullable AllocationDecided decided,
      @Nullable Throwable failure) {
    if (decided != null) {
      return decided;
    }
    log.error("{}: a round of allocation failed.", floor, failure);
    return new DispatchMessage.AllocationDecided(DecidedRound.of(List.of()), Map.of());
  }

  /** Gives the tasks to robots that are still free; the rest is for the next round. */
  void allocationDecided(DispatchMessage.AllocationDecided m) {
    isDeciding = false;
    state.changed = true;
    addLines(m.round());
    if (m.round().isUnfinished()) {
      nextRound = state.now.plus(NEXT_ROUND);
    }
    Set<String> free = exchangeTasks(m);
    Set<Long> edited = Set.copyOf(editedInRound);
    editedInRound.clear();
    Map<Long, Sentence> waiting = new HashMap<>();
    for (Decision decision : m.round().decisions()) {
      switch (decision) {
        case Decision d when edited.contains(d.task()) -> state.isRoundDue = true;
        case Decision.Assigned(long id, List<String> chosen, Sentence why) ->
            state
                .queue
                .get(id)
                .ifPresent(queued -> assign(queued, chosen, why, m.teams().get(id), free));
        case Decision.Unassigned(long id, Sentence why, List<String> drained) -> {
          waiting.put(id, rooms.explained(id, why));
          if (!drained.isEmpty()) {
            state.floorAgent.tell(new FloorMessage.RechargeRobots(drained, id));
          }
        }
      }
    }
    rooms.retain(task -> state.queue.get(task).isPresent());
    reasons = waiting;
  }

  private void addLines(DecidedRound round) {
    negotiations.add(round.lines(), Duration.between(state.now, state.clock.instant()));
    negotiations.retain(task -> state.queue.get(task).isPresent() || state.isOnFloor(task));
  }

  /** What was last said of tasks by robots' agents. */
  Map<Long, List<NegotiationEntry>> negotiations() {
    return negotiations.byTask();
  }

  /**
   * @param team whether the chosen ones have room; null where they are not several
   * @param free robots that are free now
   */
  private void assign(
      TaskQueue.Queued queued,
      List<String> chosen,
      Sentence why,
      @Nullable TeamFinding team,
      Set<String> free) {
    Mission mission = queued.mission();
    boolean isTeamKnown =
        chosen.size() < 2
            || (team != null && team.isAbout(mission, team(state.candidates(), chosen)));
    Optional<Sentence> objection =
        team != null && isTeamKnown ? team.objection() : Optional.empty();
    if (team != null && objection.isPresent()) {
      rooms.add(
          restricted(queued.job()),
          team.question(),
          objection.get(),
          state.candidates(),
          state.now);
    }
    if (isTeamKnown && objection.isEmpty() && free.containsAll(chosen)) {
      takeFromQueue(mission.id()).ifPresent(taken -> handOver(taken, chosen, why));
    } else {
      state.isRoundDue = true;
    }
  }

  /**
   * Lets robots change tasks that are not begun.
   *
   * @return who is free for another task then
   */
  private Set<String> exchangeTasks(DispatchMessage.AllocationDecided m) {
    Set<String> free =
        state.candidates().stream()
            .filter(r -> r.availability() == Availability.FREE)
            .map(Candidate::robot)
            .collect(Collectors.toCollection(HashSet::new));
    List<FloorMessage.Move> moves =
        exchanges.moves(m.round().decisions(), state.assignedTasks(), free, state.now);
    if (!moves.isEmpty()) {
      state.floorAgent.tell(new FloorMessage.ExchangeTasks(moves));
      moves.forEach(move -> free.add(move.from()));
      moves.forEach(move -> free.remove(move.to()));
    }
    return free;
  }

  /** Takes it out of the queue, unless it was cancelled or held meanwhile. */
  private Optional<Mission> takeFromQueue(long task) {
    return state
        .queue
        .get(task)
        .filter(TaskQueue.Queued::canBegin)
        .flatMap(q -> state.queue.remove(task));
  }

  private void handOver(Mission mission, List<String> chosen, Sentence why) {
    state.handedOver.put(
        mission.id(),
        TaskView.of(mission.assign(chosen, why).mission(), null, state.clock.instant()));
    state.floorAgent.tell(new FloorMessage.BeginTask(mission, chosen, why));
    state.changed = true;
  }

  /** Whether it waits for what will not come by itself: room for its team, or other robots. */
  boolean isBlocked(TaskQueue.Queued queued, @Nullable WaitExplainer plain) {
    return !queued.mission().held()
        && (state.legs.isStopped(queued.task())
            || rooms.isWithoutRoom(queued.task().id())
            || (plain != null && plain.isImpossible(state.chosen().named(queued.job()))));
  }

  /** What the last round said; of a task that it did not look at, what is plain without one. */
  Sentence waitReason(TaskQueue.Queued queued, @Nullable WaitExplainer plain) {
    Optional<Sentence> legBefore = state.legs.reasonToWait(queued.task());
    if (legBefore.isPresent()) {
      return legBefore.get();
    }
    Optional<Sentence> noRoom = rooms.reason(queued.task().id());
    if (noRoom.isPresent()) {
      return noRoom.get();
    }
    Sentence said = reasons.get(queued.task().id());
    if (said != null) {
      return said;
    }
    AllocationTask job = state.chosen().named(queued.job());
    return plain == null || plain.hasFreeRobot(job)
        ? DispatchState.LOOKING_FOR_ROBOT
        : plain.reason(job);
  }
}
