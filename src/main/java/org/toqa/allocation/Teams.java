package org.toqa.allocation;

import static java.util.Comparator.comparingDouble;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.toqa.allocation.Costs.Cost;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Gives loads that are too heavy for every robot that fits through their way to several, and leaves
 * the rest to another allocator. The team is the smallest whose robots can each carry an even
 * share; of those that are free the ones nearest to the load, the nearest of all as the leader.
 *
 * <p>Robots seldom become free together. When such a load has waited longer than every other task,
 * robots that are free are kept for it, so that it does not wait for ever. Where it is fetched and
 * set down its robots are alone: {@link PlacesInTurn}.
 */
public final class Teams implements Allocator {
  private static final int MOST_ROBOTS = 12;

  private final Allocator alone;

  /**
   * @param alone decides about loads that one robot can carry
   */
  public Teams(Allocator alone) {
    this.alone = alone;
  }

  @Override
  public List<Decision> allocate(Situation situation) {
    Round round = new Round(situation);
    situation.waiting().forEach(round::look);
    List<Job> light = round.light();
    round.decisions.addAll(alone.allocate(without(situation, light, round.taken)));
    return round.decisions;
  }

  private static final class Round {
    private final Situation situation;
    private final WaitingReason reason;
    private final Costs costs;
    private final PlacesInTurn places;
    private final List<Decision> decisions = new ArrayList<>();
    private final List<Job> light = new ArrayList<>();
    private final Map<String, Long> taken = new HashMap<>();

    Round(Situation situation) {
      this.situation = situation;
      this.reason = new WaitingReason(situation);
      this.costs = new Costs(situation);
      this.places = new PlacesInTurn(situation.inUse());
    }

    /** Decides about a task for several robots; in the order of precedence. */
    void look(Job job) {
      List<Candidate> fitting = fitting(job);
      boolean together =
          !fitting.isEmpty() && fitting.stream().noneMatch(r -> r.isStrongEnough(job));
      if (waits(job, places.objection(job, together))) {
        places.keepFor(job, together);
      } else if (together) {
        gather(job);
      } else {
        light.add(job);
      }
    }

    /** The robots for which the way of the load is wide enough. */
    private List<Candidate> fitting(Job job) {
      return situation.robots().stream().filter(r -> costs.fits(job, r)).toList();
    }

    private boolean waits(Job job, Optional<Sentence> objection) {
      objection.ifPresent(why -> decisions.add(new Decision.Waits(job.id(), why, List.of())));
      return objection.isPresent();
    }

    private void gather(Job job) {
      List<Candidate> usable =
          situation.free().stream().filter(r -> !taken.containsKey(r.robot())).toList();
      List<Candidate> nearest = team(job, usable, fitting(job), costs);
      int needed = size(job, fitting(job)).orElse(Integer.MAX_VALUE);
      if (nearest.size() == needed) {
        nearest.forEach(r -> taken.put(r.robot(), job.id()));
        places.take(job, true);
        decisions.add(assigned(job, nearest, costs));
        return;
      }
      if (light.isEmpty() && needed <= MOST_ROBOTS) {
        nearest.forEach(r -> taken.put(r.robot(), job.id()));
        places.keepFor(job, true);
      }
      decisions.add(reason.waits(job));
    }

    /** The tasks for one robot each whose places no team has taken. */
    List<Job> light() {
      return light.stream()
          .filter(job -> !waits(job, places.objectionOfUsers(job, false)))
          .toList();
    }
  }

  /** How many robots share the load evenly, of those that are not broken; empty if all cannot. */
  private static Optional<Integer> size(Job job, List<Candidate> robots) {
    return TeamSize.of(job.load(), robots.stream().filter(Teams::canBeFree).toList());
  }

  private static boolean canBeFree(Candidate robot) {
    return switch (robot.standing()) {
      case FREE, BUSY, CHARGING, HELD -> true;
      case CONNECTING, LOST, NOT_LOCALISED, ERROR, OUT_OF_SERVICE -> false;
    };
  }

  private record Priced(Candidate robot, Cost cost) {}

  /** The nearest of those that are free; fewer than are needed where not enough are. */
  private static List<Candidate> team(
      Job job, List<Candidate> free, List<Candidate> robots, Costs costs) {
    Optional<Integer> size = size(job, robots);
    if (size.isEmpty()) {
      return List.of();
    }
    Job share = share(job, size.get());
    return free.stream()
        .map(r -> new Priced(r, costs.of(share, r)))
        .filter(p -> p.cost().isPossible())
        .sorted(comparingDouble(p -> p.cost().approach()))
        .map(Priced::robot)
        .limit(size.get())
        .toList();
  }

  private static Job share(Job job, int robots) {
    return new Job(job.id(), job.load() / robots, job.start(), job.goal(), job.countsFrom());
  }

  private static Decision assigned(Job job, List<Candidate> team, Costs costs) {
    double approach = costs.of(share(job, team.size()), team.getFirst()).approach();
    Sentence why =
        Phrase.TOO_HEAVY_FOR_ONE.with(
            team.size(), job.load() / team.size(), team.getFirst().robot(), approach);
    return new Decision.Assigned(job.id(), team.stream().map(Candidate::robot).toList(), why);
  }

  private static Situation without(
      Situation situation, List<Job> waiting, Map<String, Long> taken) {
    List<Candidate> robots =
        situation.robots().stream()
            .map(r -> taken.containsKey(r.robot()) ? r.busyWith(taken.get(r.robot())) : r)
            .toList();
    return new Situation(
        situation.now(),
        situation.low(),
        situation.high(),
        situation.travel(),
        situation.chargers(),
        waiting,
        situation.given(),
        robots,
        situation.inUse());
  }
}
