package org.toqa.forecast;

import java.util.List;
import org.toqa.geometry.Vec2;

/**
 * How robots charge.
 *
 * @param points metres, map frame; empty: nobody looks at batteries
 * @param below a robot whose battery has less, of 0 to 1, charges before its next task
 * @param until as far as this
 * @param toFull seconds in which an empty battery is full
 */
public record Charging(List<Vec2> points, double below, double until, double toFull) {
  public static final Charging NONE = new Charging(List.of(), 0, 1, 0);

  public Charging {
    points = List.copyOf(points);
  }

  /** Seconds until a battery that has so much, of 0 to 1, is charged. */
  public double seconds(double battery) {
    return Math.max(0, until - battery) * toFull;
  }
}
