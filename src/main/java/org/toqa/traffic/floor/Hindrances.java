package org.toqa.traffic.floor;

import java.util.BitSet;
import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/** Finds out why a robot has no way to its goal. */
final class Hindrances {
  private final Ground ground;
  private final OwnWays ways;

  Hindrances(Ground ground, OwnWays ways) {
    this.ground = ground;
    this.ways = ways;
  }

  /**
   * @param m which wants to go somewhere and has no way there
   */
  Hindrance of(Mover m, Collection<Mover> movers) {
    Vec2 goal = Objects.requireNonNull(m.goal);
    if (m.takenBy != null) {
      return new Hindrance.PlaceTaken(m.takenBy, goal);
    }
    Optional<List<Stretch>> way = ways.roundFixed(m, movers);
    if (way.isPresent()) {
      return firstMet(m, way.get(), movers).orElse(new Hindrance.NoPlan(goal));
    }
    List<Mover> fixed = movers.stream().filter(o -> !o.movable).toList();
    return ways.alone(m)
        .flatMap(alone -> firstMet(m, alone, fixed))
        .orElseGet(() -> withoutWay(m, goal));
  }

  private Optional<Hindrance> firstMet(Mover m, List<Stretch> way, Collection<Mover> movers) {
    return way.stream()
        .map(stretch -> met(m, stretch, movers))
        .filter(Objects::nonNull)
        .findFirst();
  }

  private Hindrance withoutWay(Mover m, Vec2 goal) {
    for (Vec2 point : ways.withoutObstacles(m)) {
      int touched = SweptCells.standing(ground.grid(), point, m.radius).firstIn(ground.obstacles());
      if (touched >= 0) {
        return new Hindrance.Obstacle(ground.grid().centre(ground.grid().cell(touched)));
      }
    }
    return new Hindrance.NoWay(goal, 2 * m.radius);
  }

  private @Nullable Hindrance met(Mover m, Stretch stretch, Collection<Mover> movers) {
    for (Mover other : movers) {
      BitSet claimed = new BitSet();
      other.addClaimedTo(claimed);
      int cell = other == m ? -1 : stretch.cells().firstIn(claimed);
      if (cell >= 0) {
        Vec2 where = ground.grid().centre(ground.grid().cell(cell));
        if (!other.movable) {
          return new Hindrance.Fixed(other.name, where);
        }
        return other.course == null
            ? new Hindrance.Standing(other.name, where)
            : new Hindrance.Passing(other.name, where);
      }
    }
    return null;
  }
}
