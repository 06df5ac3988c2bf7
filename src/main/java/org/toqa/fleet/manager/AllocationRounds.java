package org.toqa.fleet.manager;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
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
import org.toqa.mission.Mission;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Sentence;

/**
 * Lets the allocator decide who carries what, floor by floor, and hands tasks over.
 *
 * <p>A round is computed on another thread from immutable values: who carries what, and whether the
 * teams have room. Of what it says that is adopted which still fits the tasks and robots as they
 * are then; the next round is asked about the rest.
 */
final class AllocationRounds {
  private static final Logger log = LoggerFactory.getLogger(AllocationRounds.class);

  /** Whoever has not answered in a round may do so in one that is so much later. */
  private static final Duration NEXT_ROUND = Duration.ofSeconds(5);

  private final FleetState fleet;
  private final RoundDecider decider;
  private final PathQuery paths;
  private final ActorRef<ManagerMessage> self;
  private final TaskExchanges exchanges = new TaskExchanges();

  /** By floor: what its robots were last seen to be kept by. */
  private final Map<String, Map<String, Availability>> availabilities = new HashMap<>();

  /** By floor: which of its places were last seen to be in use. */
  private final Map<String, List<PlaceUse>> placesSeen = new HashMap<>();

  /** By floor and task: what the last round said of those that wait. */
  private final Map<String, Map<Long, Sentence>> reasons = new HashMap<>();

  private final RoomFindings rooms = new RoomFindings();

  /** Floors with a running round. */
  private final Set<String> deciding = new HashSet<>();

  /** By floor whose last round was not answered by all, when the next one is due. */
  private final Map<String, Instant> nextRounds = new HashMap<>();

  private final NegotiationLines negotiations = new NegotiationLines();

  /** By floor: tasks of its running round of which something else was ordered since it began. */
  private final Map<String, Set<Long>> editedInRound = new HashMap<>();

  AllocationRounds(
      FleetState fleet, RoundDecider decider, PathQuery paths, ActorRef<ManagerMessage> self) {
    this.fleet = fleet;
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
    reasons.getOrDefault(before.floor(), new HashMap<>()).remove(before.id());
    if (deciding.contains(before.floor())) {
      editedInRound.computeIfAbsent(before.floor(), _ -> new HashSet<>()).add(before.id());
    }
  }

  /** A floor has told how it is: it is time for a round where robots or places became free. */
  void floorReported(String floor) {
    Map<String, Availability> now =
        fleet.candidates(floor).stream()
            .collect(Collectors.toMap(Candidate::robot, Candidate::availability));
    List<PlaceUse> inUse = fleet.placesInUse(floor);
    boolean isNews = !now.equals(availabilities.put(floor, now));
    if (!inUse.equals(placesSeen.put(floor, inUse)) || isNews) {
      fleet.dueFloors.add(floor);
    }
  }

  /** Lets the allocator decide, on a thread of its own, on each floor where it is time. */
  void beginDueRounds() {
    retryTeams();
    nextRounds
        .entrySet()
        .removeIf(
            next -> !fleet.now.isBefore(next.getValue()) && fleet.dueFloors.add(next.getKey()));
    for (String floor : List.copyOf(fleet.dueFloors)) {
      if (fleet.reports.containsKey(floor) && !deciding.contains(floor)) {
        fleet.dueFloors.remove(floor);
        beginRound(requireNonNull(fleet.floorMaps.get(floor)));
      }
    }
  }

  /** What was said of them is said until the next round is over. */
  private void retryTeams() {
    rooms
        .takeDue(fleet.clock.instant())
        .forEach((task, why) -> fleet.queue.get(task).ifPresent(queued -> tryAgain(queued, why)));
  }

  private void tryAgain(TaskQueue.Queued queued, Sentence why) {
    String floor = queued.task().floor();
    reasons.computeIfAbsent(floor, _ -> new HashMap<>()).put(queued.task().id(), why);
    fleet.dueFloors.add(floor);
  }

  private void beginRound(FloorMap floor) {
    List<Candidate> robotsHere = fleet.candidates(floor.name());
    List<GivenTask> given =
        exchanges.exchangeableTasks(
            fleet.assignedTasks(floor.name()), fleet.robotsOn(floor.name()), fleet.now);
    double strongest = maxFreeLoad(robotsHere, given);
    double strongestOfAll = robotsHere.stream().mapToDouble(Candidate::maxLoad).max().orElse(0);
    boolean isAnyFree = strongest > 0;
    List<AllocationTask> jobs =
        fleet
            .queue
            .firstJobs(
                floor.name(),
                queued ->
                    fleet.legs.reasonToWait(queued.task()).isEmpty()
                        && (queued.task().load() <= strongest
                            || (isAnyFree
                                && queued.task().load() > strongestOfAll
                                && !rooms.isWithoutRoom(queued.task().id()))),
                FleetState.TASKS_CONSIDERED)
            .stream()
            .map(rooms::restricted)
            .toList();
    if (jobs.isEmpty()) {
      reasons.remove(floor.name());
      fleet.changed = true;
    }
    if (jobs.isEmpty() && given.isEmpty()) {
      return;
    }
    deciding.add(floor.name());
    AllocationProblem problem = problem(floor, jobs, given, robotsHere);
    Map<Long, Mission> missions =
        jobs.stream()
            .flatMap(job -> fleet.queue.get(job.id()).stream())
            .map(TaskQueue.Queued::mission)
            .collect(Collectors.toMap(Mission::id, mission -> mission));
    Executor executor = fleet.runtime.threadPerTaskExecutor("allocation-" + floor.name());
    var _ =
        decider
            .decide(floor.name(), problem, executor, fleet.now)
            .thenComposeAsync(round -> withTeams(floor, problem, missions, round), executor)
            .whenComplete(
                (decided, failure) -> self.tell(roundMessage(floor.name(), decided, failure)));
  }

  /**
   * Asks for room for the teams that came out.
   *
   * @param missions the problem's waiting tasks, by task
   */
  private CompletableFuture<ManagerMessage.AllocationDecided> withTeams(
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
                new ManagerMessage.AllocationDecided(
                    floor.name(),
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

  /** What a robot that is free, or may be by an exchange, carries; nothing while none is free. */
  private static double maxFreeLoad(List<Candidate> robotsHere, List<GivenTask> given) {
    Set<String> holders = given.stream().map(GivenTask::robot).collect(Collectors.toSet());
    return robotsHere.stream().noneMatch(r -> r.availability() == Availability.FREE)
        ? Double.NEGATIVE_INFINITY
        : robotsHere.stream()
            .filter(r -> r.availability() == Availability.FREE || holders.contains(r.robot()))
            .mapToDouble(Candidate::maxLoad)
            .max()
            .orElse(Double.NEGATIVE_INFINITY);
  }

  AllocationProblem problem(
      FloorMap floor,
      List<AllocationTask> jobs,
      List<GivenTask> given,
      List<Candidate> robotsHere) {
    OccupancyGrid grid = floor.grid();
    Vec2 size = new Vec2(grid.width(), grid.height()).times(grid.resolution());
    return new AllocationProblem(
        fleet.clock.instant(),
        grid.origin(),
        grid.origin().plus(size),
        new Terrain(
            requireNonNull(fleet.distances.get(floor.name())), FleetState.chargerPositions(floor)),
        jobs,
        given,
        robotsHere,
        fleet.placesInUse(floor.name()));
  }

  private static ManagerMessage roundMessage(
      String floor,
      ManagerMessage.@Nullable AllocationDecided decided,
      @Nullable Throwable failure) {
    if (decided != null) {
      return decided;
    }
    log.error("{}: a round of allocation failed.", floor, failure);
    return new ManagerMessage.AllocationDecided(floor, DecidedRound.of(List.of()), Map.of());
  }

  /** Gives the tasks to robots that are still free; the rest is for the next round. */
  void allocationDecided(ManagerMessage.AllocationDecided m) {
    deciding.remove(m.floor());
    fleet.changed = true;
    addLines(m.round());
    if (m.round().isUnfinished()) {
      nextRounds.put(m.floor(), fleet.now.plus(NEXT_ROUND));
    }
    ActorRef<FloorMessage> floor = requireNonNull(fleet.floors.get(m.floor()));
    Set<String> free = exchangeTasks(floor, m);
    Set<Long> edited = Objects.requireNonNullElse(editedInRound.remove(m.floor()), Set.of());
    Map<Long, Sentence> waiting = new HashMap<>();
    for (Decision decision : m.round().decisions()) {
      switch (decision) {
        case Decision d when edited.contains(d.task()) -> fleet.dueFloors.add(m.floor());
        case Decision.Assigned(long id, List<String> chosen, Sentence why) ->
            fleet
                .queue
                .get(id)
                .ifPresent(queued -> assign(queued, chosen, why, m.teams().get(id), free));
        case Decision.Unassigned(long id, Sentence why, List<String> drained) -> {
          waiting.put(id, rooms.explained(id, why));
          if (!drained.isEmpty()) {
            floor.tell(new FloorMessage.RechargeRobots(drained, id));
          }
        }
      }
    }
    rooms.retain(task -> fleet.queue.get(task).isPresent());
    reasons.put(m.floor(), waiting);
  }

  private void addLines(DecidedRound round) {
    negotiations.add(round.lines(), Duration.between(fleet.now, fleet.clock.instant()));
    negotiations.retain(
        task -> fleet.queue.get(task).isPresent() || fleet.floorOf(task).isPresent());
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
            || (team != null
                && team.isAbout(mission, team(fleet.candidates(mission.task().floor()), chosen)));
    Optional<Sentence> objection =
        team != null && isTeamKnown ? team.objection() : Optional.empty();
    if (team != null && objection.isPresent()) {
      rooms.add(mission.id(), team.question(), objection.get(), fleet.clock.instant());
    }
    if (isTeamKnown && objection.isEmpty() && free.containsAll(chosen)) {
      takeFromQueue(mission.id()).ifPresent(taken -> handOver(taken, chosen, why));
    } else {
      fleet.dueFloors.add(mission.task().floor());
    }
  }

  /**
   * Lets robots change tasks that are not begun.
   *
   * @return who is free for another task then
   */
  private Set<String> exchangeTasks(
      ActorRef<FloorMessage> floor, ManagerMessage.AllocationDecided m) {
    Set<String> free =
        fleet.candidates(m.floor()).stream()
            .filter(r -> r.availability() == Availability.FREE)
            .map(Candidate::robot)
            .collect(Collectors.toCollection(HashSet::new));
    List<FloorMessage.Move> moves =
        exchanges.moves(m.round().decisions(), fleet.assignedTasks(m.floor()), free, fleet.now);
    if (!moves.isEmpty()) {
      floor.tell(new FloorMessage.ExchangeTasks(moves));
      moves.forEach(move -> free.add(move.from()));
      moves.forEach(move -> free.remove(move.to()));
    }
    return free;
  }

  /** Takes it out of the queue, unless it was cancelled or held meanwhile. */
  private Optional<Mission> takeFromQueue(long task) {
    return fleet
        .queue
        .get(task)
        .filter(TaskQueue.Queued::canBegin)
        .flatMap(q -> fleet.queue.remove(task));
  }

  private void handOver(Mission mission, List<String> chosen, Sentence why) {
    fleet.handedOver.put(
        mission.id(),
        TaskView.of(mission.assign(chosen, why).mission(), null, fleet.clock.instant()));
    requireNonNull(fleet.floors.get(mission.task().floor()))
        .tell(new FloorMessage.BeginTask(mission, chosen, why));
    fleet.changed = true;
  }

  /** Whether it waits for what will not come by itself: room for its team, or other robots. */
  boolean isBlocked(TaskQueue.Queued queued, @Nullable WaitExplainer plain) {
    return !queued.mission().held()
        && (fleet.legs.isStopped(queued.task())
            || rooms.isWithoutRoom(queued.task().id())
            || (plain != null && plain.isImpossible(queued.job())));
  }

  /** What the last round said; of a task that it did not look at, what is plain without one. */
  Sentence waitReason(TaskQueue.Queued queued, @Nullable WaitExplainer plain) {
    Optional<Sentence> legBefore = fleet.legs.reasonToWait(queued.task());
    if (legBefore.isPresent()) {
      return legBefore.get();
    }
    Optional<Sentence> noRoom = rooms.reason(queued.task().id());
    if (noRoom.isPresent()) {
      return noRoom.get();
    }
    Sentence said = reasons.getOrDefault(queued.task().floor(), Map.of()).get(queued.task().id());
    if (said != null) {
      return said;
    }
    return plain == null ? FleetState.LOOKING_FOR_ROBOT : plain.reason(queued.job());
  }
}
