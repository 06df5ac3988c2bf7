package org.toqa.fleet.supervision;

import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/**
 * A box that is to be carried.
 *
 * @param number that its cameras read on it, above 0
 * @param target where it shall lie, metres, map frame
 * @param place where it was seen last, metres, map frame; null: not yet, or it is there no more
 * @param weight kilograms, as an arm weighed it; null: it was not weighed yet
 * @param task the one that carries it; null: none does
 * @param tries how many tasks it had
 */
public record SupervisedBox(
    int number,
    Vec2 target,
    @Nullable Vec2 place,
    @Nullable Double weight,
    @Nullable Long task,
    int tries,
    boolean delivered) {

  /** One that was not seen yet. */
  static SupervisedBox unseen(int number, Vec2 target) {
    return new SupervisedBox(number, target, null, null, null, 0, false);
  }

  /** Whether it was found and nobody was told to carry it. */
  boolean isToOrder() {
    return place != null && task == null && !delivered;
  }

  boolean isHeavierThan(double kilograms) {
    return weight != null && weight > kilograms;
  }

  SupervisedBox seenAt(Vec2 there) {
    return new SupervisedBox(number, target, there, weight, task, tries, delivered);
  }

  SupervisedBox weighing(double kilograms) {
    return new SupervisedBox(number, target, place, kilograms, task, tries, delivered);
  }

  SupervisedBox orderedAs(long id) {
    return new SupervisedBox(number, target, place, weight, id, tries, delivered);
  }

  /** Its task has ended without it; it is to be ordered anew where it lies. */
  SupervisedBox withoutTask() {
    return new SupervisedBox(number, target, place, weight, null, tries + 1, delivered);
  }

  /** The same, and nobody knows where it lies. */
  SupervisedBox missing() {
    return new SupervisedBox(number, target, null, weight, null, tries + 1, delivered);
  }

  SupervisedBox atTarget() {
    return new SupervisedBox(number, target, place, weight, task, tries, true);
  }
}
