package org.toqa.agent.chassis;

import java.util.Optional;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.CameraView;

/**
 * The obstacles round one simulated body, which itself is no part of it. Called by the body's
 * thread.
 */
public interface Surroundings {

  /** An endless empty floor. */
  Surroundings EMPTY =
      new Surroundings() {
        @Override
        public void setTruePose(Pose truth) {}

        @Override
        public double distance(Pose ray, double farthest) {
          return farthest;
        }

        @Override
        public boolean isMarked(Vec2 point) {
          return false;
        }
      };

  /**
   * Where people have put the body since it was asked last, map frame; empty: they have not. Asked
   * at every exchange.
   */
  default Optional<Pose> takePlace() {
    return Optional.empty();
  }

  /**
   * Told at every exchange where the body really is: what no robot knows of itself.
   *
   * @param truth map frame
   */
  void setTruePose(Pose truth);

  /**
   * Told at every exchange what lies on the body and on others together.
   *
   * @param load null: nothing
   */
  default void setSharedLoad(@Nullable SharedLoad load) {}

  /**
   * Kilograms that the body truly bears of that; empty where nothing lies on all of them, or it is
   * not simulated.
   */
  default OptionalDouble borneShare() {
    return OptionalDouble.empty();
  }

  /**
   * What the body's cameras see, if it has any.
   *
   * @param from where they are, map frame
   * @return null: it has none, or they see nothing at all
   */
  default @Nullable CameraView view(Vec2 from) {
    return null;
  }

  /**
   * The body's hand closes.
   *
   * @param hand where, metres, map frame
   * @return kilograms of the box there, which it has from now on; 0 where there is none; empty
   *     where no boxes are simulated
   */
  default OptionalDouble grasp(Vec2 hand) {
    return OptionalDouble.empty();
  }

  /**
   * The body's hand opens, and what it held lies there.
   *
   * @param hand metres, map frame
   */
  default void release(Vec2 hand) {}

  /**
   * Metres from a point to the first thing in a direction.
   *
   * @param ray from where and in which direction, map frame
   * @param farthest metres; the answer where nothing is nearer
   */
  double distance(Pose ray, double farthest);

  /**
   * Whether a mark lies there on the floor that tells a body over it where it is.
   *
   * @param point map frame
   */
  boolean isMarked(Vec2 point);
}
