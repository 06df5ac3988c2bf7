package org.toqa.allocation;

import java.time.Instant;
import java.util.List;
import org.toqa.geometry.Vec2;

/**
 * What an allocator knows of a floor.
 *
 * @param low the floor's lower left corner, metres, map frame
 * @param high the floor's upper right corner, metres, map frame
 * @param travel the lengths of ways on the floor
 * @param chargers the floor's charging points, metres, map frame
 * @param waiting tasks that no robot has, the most urgent ones at least
 * @param given tasks that robots have but whose loads are not picked up, as far as they may still
 *     go to other robots; no two of one robot
 * @param robots all of the floor
 * @param inUse places where tasks that have robots are being fetched or set down
 */
public record Situation(
    Instant now,
    Vec2 low,
    Vec2 high,
    Travel travel,
    List<Vec2> chargers,
    List<Job> waiting,
    List<Given> given,
    List<Candidate> robots,
    List<PlaceUse> inUse) {

  /** A task that a robot has and that another one may still take over. */
  public record Given(Job job, String robot) {}

  public Situation {
    chargers = List.copyOf(chargers);
    waiting = waiting.stream().sorted(Job.BY_PRECEDENCE).toList();
    given = List.copyOf(given);
    robots = List.copyOf(robots);
    inUse = List.copyOf(inUse);
  }

  List<Candidate> free() {
    return robots.stream().filter(Candidate::isFree).toList();
  }
}
