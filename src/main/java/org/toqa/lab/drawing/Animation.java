package org.toqa.lab.drawing;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Vec2;

/**
 * A scene with bodies that move over it. Its SVG is the scene alone.
 *
 * @param ground what does not move
 * @param step seconds from one point of a body's track to the next
 */
public record Animation(Scene ground, double step, List<Body> bodies) implements Drawing {
  /** At most so many points of a track are kept. */
  private static final int MOST_POINTS = 400;

  /**
   * A disc that moves.
   *
   * @param label for a person
   * @param radius metres
   * @param track where its middle is at each step, metres in the scene's frame; where it ends the
   *     body stands from then on
   */
  public record Body(String label, double radius, Colour colour, List<Vec2> track) {
    public Body {
      track = List.copyOf(track);
    }
  }

  /**
   * @throws IllegalArgumentException if a body is nowhere, or no time passes
   */
  public Animation {
    bodies = List.copyOf(bodies);
    if (!(step > 0) || bodies.stream().anyMatch(body -> body.track().isEmpty())) {
      throw new IllegalArgumentException("The bodies of " + ground.name() + " do not move.");
    }
  }

  /** With longer steps where there were too many to be kept: the first of each few points stays. */
  public static Animation of(Scene ground, double step, List<Body> bodies) {
    int most = bodies.stream().mapToInt(body -> body.track().size()).max().orElse(0);
    int every = Math.max(1, Math.ceilDiv(most, MOST_POINTS));
    return new Animation(
        ground,
        step * every,
        bodies.stream()
            .map(b -> new Body(b.label(), b.radius(), b.colour(), thinned(b.track(), every)))
            .toList());
  }

  private static List<Vec2> thinned(List<Vec2> track, int every) {
    List<Vec2> kept = new ArrayList<>();
    for (int i = 0; i < track.size(); i += every) {
      kept.add(track.get(i));
    }
    if ((track.size() - 1) % every != 0) {
      kept.add(track.getLast());
    }
    return kept;
  }

  @Override
  public String name() {
    return ground.name();
  }

  @Override
  public String title() {
    return ground.title();
  }

  @Override
  public String svg() {
    return ground.svg();
  }
}
