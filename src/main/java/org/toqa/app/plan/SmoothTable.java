package org.toqa.app.plan;

import java.util.Formatter;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.motion.WheelCommand;
import org.toqa.planning.smooth.curve.PolynomialCurve;

/** A smooth curve for people, in a terminal. */
final class SmoothTable {
  private SmoothTable() {}

  static String of(SmoothDrive drive) {
    Formatter table = new Formatter(Locale.ROOT);
    addPlace(table, "from", drive.trajectory().start());
    addPlace(table, "to", drive.trajectory().end());
    table.format("length  %.3f m driven%n", drive.curve().length());
    table.format("time    %.1f s%n", drive.schedule().duration());
    table.format("bend    at most %.2f radians per metre%n", drive.curve().maxCurvature());
    table.format("turns   %d on the spot%n", drive.turnsOnSpot());
    table.format("y(x)    %s%n", polynomial(drive.polynomial()));
    PlanTable.addSegments(table, drive.trajectory());
    addWheels(table, drive);
    return table.toString().stripTrailing();
  }

  private static String polynomial(@Nullable PolynomialCurve curve) {
    return curve == null
        ? "no polynomial is free from start to goal"
        : "a polynomial of degree %d is free too".formatted(curve.degree());
  }

  private static void addPlace(Formatter table, String name, Pose pose) {
    table.format("%-8s%.3f, %.3f m%n", name, pose.x(), pose.y());
  }

  private static void addWheels(Formatter table, SmoothDrive drive) {
    table.format(
        "%n  t (s)  v (m/s)  w (rad/s)  left (m/s)  ISPA  pulse (ms)  right (m/s)  ISPA  pulse"
            + " (ms)%n");
    for (WheelCommand c : drive.schedule().commands()) {
      table.format("%7.2f %8.3f %10.3f", c.time(), c.v(), c.w());
      table.format(
          " %11.3f %5d %11.1f",
          c.left().speed(), c.left().amplitude(), c.left().pulseMilliseconds());
      table.format(
          " %12.3f %5d %11.1f%n",
          c.right().speed(), c.right().amplitude(), c.right().pulseMilliseconds());
    }
  }
}
