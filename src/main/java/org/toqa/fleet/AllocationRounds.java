package org.toqa.fleet;

import static java.util.Objects.requireNonNull;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Collectors;
import org.apache.pekko.actor.typed.ActorRef;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.allocation.Allocator;
import org.toqa.allocation.Candidate;
import org.toqa.allocation.Decision;
import org.toqa.allocation.Job;
import org.toqa.allocation.PlaceUse;
import org.toqa.allocation.Situation;
import org.toqa.allocation.Situation.Given;
import org.toqa.allocation.Standing;
import org.toqa.allocation.WaitingReason;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.mission.Mission;
import org.toqa.wording.Sentence;

/** Lets the allocator decide who carries what, floor by floor, and hands tasks over. */
final class AllocationRounds {
  private static final Logger log = LoggerFactory.getLogger(AllocationRounds.class);

  private final FleetState fleet;
  private final Allocator allocator;
  private final ActorRef<ManagerMessage> self;
  private final Exchanges exchanges = new Exchanges();

  /** By floor: what its robots were last seen to be kept by. */
  private final Map<String, Map<String, Standing>> standings = new HashMap<>();

  /** By floor: which of its places were last seen to be in use. */
  private final Map<String, List<PlaceUse>> placesSeen = new HashMap<>();

  /** By floor and task: what the last round said of those that wait. */
  private final Map<String, Map<Long, Sentence>> reasons = new HashMap<>();

  /** Tasks for several robots that have no room round the load, and why. */
  private final Map<Long, Sentence> roomless = new HashMap<>();

  /** Floors with a round under way. */
  private final Set<String> deciding = new HashSet<>();

  AllocationRounds(FleetState fleet, Allocator allocator, ActorRef<ManagerMessage> self) {
    this.fleet = fleet;
    this.allocator = allocator;
    this.self = self;
  }

  /** A floor has told how it is: it is time for a round where robots or places became free. */
  void reported(String floor) {
    Map<String, Standing> now =
        fleet.candidates(floor).stream()
            .collect(Collectors.toMap(Candidate::robot, Candidate::standing));
    List<PlaceUse> inUse = fleet.placesInUse(floor);
    boolean isNews = !now.equals(standings.put(floor, now));
    if (!inUse.equals(placesSeen.put(floor, inUse)) || isNews) {
      fleet.due.add(floor);
    }
  }

  /** Lets the allocator decide, on a thread of its own, on each floor where it is time. */
  void begin() {
    for (String floor : List.copyOf(fleet.due)) {
      if (fleet.reports.containsKey(floor) && !deciding.contains(floor)) {
        fleet.due.remove(floor);
        beginRound(requireNonNull(fleet.maps.get(floor)));
      }
    }
  }

  private void beginRound(FloorMap floor) {
    List<Candidate> robotsHere = fleet.candidates(floor.name());
    List<Given> given =
        exchanges.given(
            fleet.missions(floor.name()), fleet.robotViews(floor.name()), fleet.clock.instant());
    double strongest = strongest(robotsHere, given);
    double strongestOfAll = robotsHere.stream().mapToDouble(Candidate::maxLoad).max().orElse(0);
    boolean isAnyFree = strongest > 0;
    List<Job> jobs =
        fleet.queue.first(
            floor.name(),
            job ->
                job.load() <= strongest
                    || (isAnyFree
                        && job.load() > strongestOfAll
                        && !roomless.containsKey(job.id())),
            FleetState.LOOKED_AT);
    if (jobs.isEmpty()) {
      reasons.remove(floor.name());
      fleet.changed = true;
    }
    if (jobs.isEmpty() && given.isEmpty()) {
      return;
    }
    deciding.add(floor.name());
    Situation situation = situation(floor, jobs, given, robotsHere);
    var _ =
        CompletableFuture.supplyAsync(
                () -> allocator.allocate(situation),
                round -> Thread.ofVirtual().name("allocation-" + floor.name()).start(round))
            .whenComplete(
                (decisions, failure) -> self.tell(decided(floor.name(), decisions, failure)));
  }

  /** What a robot that is free, or may be by an exchange, carries; nothing while none is free. */
  private static double strongest(List<Candidate> robotsHere, List<Given> given) {
    Set<String> holders = given.stream().map(Given::robot).collect(Collectors.toSet());
    return robotsHere.stream().noneMatch(r -> r.standing() == Standing.FREE)
        ? Double.NEGATIVE_INFINITY
        : robotsHere.stream()
            .filter(r -> r.standing() == Standing.FREE || holders.contains(r.robot()))
            .mapToDouble(Candidate::maxLoad)
            .max()
            .orElse(Double.NEGATIVE_INFINITY);
  }

  Situation situation(
      FloorMap floor, List<Job> jobs, List<Given> given, List<Candidate> robotsHere) {
    OccupancyGrid grid = floor.grid();
    Vec2 size = new Vec2(grid.width(), grid.height()).times(grid.resolution());
    return new Situation(
        fleet.clock.instant(),
        grid.origin(),
        grid.origin().plus(size),
        requireNonNull(fleet.distances.get(floor.name())),
        FleetState.chargers(floor),
        jobs,
        given,
        robotsHere,
        fleet.placesInUse(floor.name()));
  }

  private static ManagerMessage decided(
      String floor, @Nullable List<Decision> decisions, @Nullable Throwable failure) {
    if (failure != null) {
      log.error("{}: a round of allocation failed.", floor, failure);
    }
    return new ManagerMessage.Decided(floor, decisions == null ? List.of() : decisions);
  }

  /** Gives the tasks to robots that are still free; the rest is for the next round. */
  void decided(ManagerMessage.Decided m) {
    deciding.remove(m.floor());
    fleet.changed = true;
    ActorRef<FloorMessage> floor = requireNonNull(fleet.floors.get(m.floor()));
    Set<String> free = exchange(floor, m);
    Map<Long, Sentence> waiting = new HashMap<>();
    for (Decision decision : m.decisions()) {
      switch (decision) {
        case Decision.Assigned(long id, List<String> chosen, Sentence why) -> {
          Optional<Sentence> objection = objection(id, chosen.size(), m.floor());
          if (objection.isPresent()) {
            roomless.put(id, objection.get());
            fleet.due.add(m.floor());
          } else if (free.containsAll(chosen)) {
            takeOut(id).ifPresent(mission -> handOver(mission, chosen, why));
          } else if (fleet.queue.get(id).isPresent()) {
            fleet.due.add(m.floor());
          }
        }
        case Decision.Waits(long id, Sentence why, List<String> drained) -> {
          waiting.put(id, why);
          if (!drained.isEmpty()) {
            floor.tell(new FloorMessage.Recharge(drained, id));
          }
        }
      }
    }
    roomless.keySet().removeIf(task -> fleet.queue.get(task).isEmpty());
    reasons.put(m.floor(), waiting);
  }

  private Optional<Sentence> objection(long task, int team, String floor) {
    TeamRoom room = new TeamRoom(requireNonNull(fleet.maps.get(floor)).grid());
    return fleet.queue.get(task).flatMap(queued -> room.objection(queued.mission(), team));
  }

  /**
   * Lets robots change tasks that are not begun.
   *
   * @return who is free for another task then
   */
  private Set<String> exchange(ActorRef<FloorMessage> floor, ManagerMessage.Decided m) {
    Set<String> free =
        fleet.candidates(m.floor()).stream()
            .filter(r -> r.standing() == Standing.FREE)
            .map(Candidate::robot)
            .collect(Collectors.toCollection(HashSet::new));
    List<FloorMessage.Move> moves =
        exchanges.moves(m.decisions(), fleet.missions(m.floor()), free, fleet.clock.instant());
    if (!moves.isEmpty()) {
      floor.tell(new FloorMessage.Exchange(moves));
      moves.forEach(move -> free.add(move.from()));
      moves.forEach(move -> free.remove(move.to()));
    }
    return free;
  }

  /** Takes it out of the queue, unless it was cancelled or held meanwhile. */
  private Optional<Mission> takeOut(long task) {
    return fleet
        .queue
        .get(task)
        .filter(TaskQueue.Queued::mayBegin)
        .flatMap(q -> fleet.queue.remove(task));
  }

  private void handOver(Mission mission, List<String> chosen, Sentence why) {
    fleet.handedOver.put(
        mission.id(),
        TaskView.of(mission.assign(chosen, why).mission(), null, fleet.clock.instant()));
    requireNonNull(fleet.floors.get(mission.task().floor()))
        .tell(new FloorMessage.Begin(mission, chosen, why));
    fleet.changed = true;
  }

  /** What the last round said; of a task that it did not look at, what is plain without one. */
  Sentence reason(TaskQueue.Queued queued, @Nullable WaitingReason plain) {
    Sentence noRoom = roomless.get(queued.task().id());
    if (noRoom != null) {
      return noRoom;
    }
    Sentence said = reasons.getOrDefault(queued.task().floor(), Map.of()).get(queued.task().id());
    if (said != null) {
      return said;
    }
    return plain == null ? FleetState.NOT_LOOKED_AT : plain.of(queued.job());
  }
}
