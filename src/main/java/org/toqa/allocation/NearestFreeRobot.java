package org.toqa.allocation;

import static java.util.Comparator.comparingDouble;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.toqa.geometry.Vec2;

/** The free robot nearest to the load, as the crow flies, of those that can carry it alone. */
public final class NearestFreeRobot implements Allocator {

  @Override
  public Decision allocate(double load, Vec2 object, List<Candidate> robots) {
    if (robots.isEmpty()) {
      return new Decision.Waits("No robot has been added yet.");
    }
    List<Candidate> strongEnough = robots.stream().filter(r -> r.maxLoad() >= load).toList();
    if (strongEnough.isEmpty()) {
      double most = robots.stream().mapToDouble(Candidate::maxLoad).max().orElse(0);
      return new Decision.Waits(
          String.format(
              Locale.ROOT,
              "No robot can carry %s kg: the strongest carries %s kg.",
              kilograms(load),
              kilograms(most)));
    }
    Optional<Candidate> nearest =
        strongEnough.stream()
            .filter(Candidate::available)
            .min(comparingDouble(r -> r.position().distanceTo(object)));
    if (nearest.isEmpty()) {
      return new Decision.Waits(
          strongEnough.size() == 1
              ? "The only robot that can carry it is not free."
              : "None of the " + strongEnough.size() + " robots that can carry it is free.");
    }
    return new Decision.Assigned(
        List.of(nearest.get().robot()),
        String.format(
            Locale.ROOT,
            "the nearest free robot, %.1f m from the load",
            nearest.get().position().distanceTo(object)));
  }

  private static String kilograms(double load) {
    return load == Math.rint(load)
        ? String.format(Locale.ROOT, "%.0f", load)
        : Double.toString(load);
  }
}
