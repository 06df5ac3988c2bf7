package org.toqa.allocation;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.AllocationProblem.GivenTask;
import org.toqa.geometry.Vec2;

/** Situations on an empty floor of 80 m by 10 m, where paths are straight. */
final class Floors {
  static final Instant NOON = Instant.parse("2026-11-21T12:00:00Z");
  private static final double LENGTH = 80;
  private static final double WIDTH = 10;

  private Floors() {}

  static AllocationProblem situation(List<AllocationTask> waiting, List<Candidate> robots) {
    return situation(NOON, waiting, List.of(), robots);
  }

  static AllocationProblem situation(
      Instant now, List<AllocationTask> waiting, List<GivenTask> given, List<Candidate> robots) {
    return situation(now, waiting, given, robots, List.of());
  }

  static AllocationProblem situation(
      Instant now,
      List<AllocationTask> waiting,
      List<GivenTask> given,
      List<Candidate> robots,
      List<PlaceUse> inUse) {
    return new AllocationProblem(
        now,
        Vec2.ZERO,
        new Vec2(LENGTH, WIDTH),
        new Terrain(PathLengths.STRAIGHT, List.of()),
        waiting,
        given,
        robots,
        inUse);
  }

  /** One that came at noon, from (x, 5) to (x, 6). */
  static AllocationTask job(long id, double load, double x) {
    return new AllocationTask(id, load, new Vec2(x, 5), new Vec2(x, 6), NOON);
  }

  static Candidate free(String name, double maxLoad, double x) {
    return robot(name, maxLoad, x, Availability.FREE, null);
  }

  static Candidate busy(String name, double maxLoad, double x, long task) {
    return robot(name, maxLoad, x, Availability.BUSY, task);
  }

  /** At (x, 5), where it parks, with a full battery. */
  static Candidate robot(
      String name, double maxLoad, double x, Availability standing, @Nullable Long task) {
    Vec2 place = new Vec2(x, 5);
    return new Candidate(name, maxLoad, 0.255, 0.25, true, place, place, 1.0, standing, task);
  }

  /**
   * Jobs and robots anywhere; some loads too heavy for some robots, some robots not free.
   *
   * @param given the first robots have a task each that may still go to others, from id 1000
   */
  static AllocationProblem random(long seed, int tasks, int robots, int given) {
    Random random = new Random(seed);
    List<Candidate> candidates = new ArrayList<>();
    List<GivenTask> held = new ArrayList<>();
    for (int i = 0; i < robots; i++) {
      boolean isHolder = i < given;
      boolean isFree = !isHolder && random.nextInt(4) > 0;
      candidates.add(
          new Candidate(
              "r" + i,
              isHolder ? 9 : 3 + 2 * random.nextInt(4),
              0.255,
              random.nextBoolean() ? 0.25 : 0.1,
              true,
              anywhere(random),
              anywhere(random),
              random.nextBoolean() ? null : random.nextDouble(),
              isFree ? Availability.FREE : Availability.BUSY,
              null));
      if (isHolder) {
        held.add(new GivenTask(anyJob(1000 + i, random, 9), "r" + i));
      }
    }
    List<AllocationTask> waiting = new ArrayList<>();
    for (int i = 0; i < tasks; i++) {
      waiting.add(anyJob(i, random, 11));
    }
    return situation(NOON, waiting, held, candidates);
  }

  private static AllocationTask anyJob(long id, Random random, double most) {
    return new AllocationTask(
        id,
        most * random.nextDouble(),
        anywhere(random),
        anywhere(random),
        NOON.minusSeconds(random.nextInt(600)));
  }

  private static Vec2 anywhere(Random random) {
    return new Vec2(LENGTH * random.nextDouble(), WIDTH * random.nextDouble());
  }
}
