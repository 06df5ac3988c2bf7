package org.toqa.agent.formation;

import com.google.errorprone.annotations.FormatMethod;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.config.AgentConfig;
import org.toqa.formation.Shape;
import org.toqa.link.message.ServerMessage.CarriedPart;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Follower;
import org.toqa.link.message.ServerMessage.Lead;
import org.toqa.link.trust.Fingerprint;

/**
 * In which formations a robot takes no part. Each rule answers with the sentence that goes back to
 * the server, or with nothing.
 */
public final class FormationRules {

  private static final double LARGEST_TOLERANCE = 0.5;
  private static final double LARGEST_OFFSET = 50;

  /** Metres from the map's origin. */
  private static final double FARTHEST_LOAD = 100_000;

  private static final int MOST_FOLLOWERS = Shape.MOST_ROBOTS - 1;
  private static final int LARGEST_PORT = 65_535;

  private final AgentConfig config;
  private final boolean encrypted;

  /**
   * @param encrypted whether this robot's link is
   */
  public FormationRules(AgentConfig config, boolean encrypted) {
    this.config = config;
    this.encrypted = encrypted;
  }

  public Optional<String> objectionTo(Lead lead) {
    List<String> names = lead.followers().stream().map(Follower::robot).toList();
    if (names.isEmpty() || names.size() > MOST_FOLLOWERS) {
      return objection("A leader has 1 to %d followers, not %d.", MOST_FOLLOWERS, names.size());
    }
    if (names.stream().distinct().count() < names.size() || names.contains(config.name())) {
      return objection(
          "The followers must be other robots than %s, each named once.", config.name());
    }
    for (Follower follower : lead.followers()) {
      if (follower.port() < 1 || follower.port() > LARGEST_PORT) {
        return objection("The port of %s is from 1 to %d.", follower.robot(), LARGEST_PORT);
      }
      Optional<String> objection = objectionToFingerprint(follower.robot(), follower.fingerprint());
      if (objection.isPresent()) {
        return objection;
      }
    }
    return objectionToTolerance(lead.tolerance()).or(() -> objectionTo(lead.carries()));
  }

  public Optional<String> objectionTo(Follow follow) {
    if (follow.leader().equals(config.name())) {
      return objection("%s cannot follow itself.", config.name());
    }
    if (encrypted && follow.fingerprint() == null) {
      return objection(
          "%s is paired: it knows its leader by the fingerprint, which is missing.", config.name());
    }
    Optional<String> objection = objectionToFingerprint(follow.leader(), follow.fingerprint());
    if (objection.isPresent()) {
      return objection;
    }
    double away = follow.offset().norm();
    if (!(away >= config.footprint() / 2 && away <= LARGEST_OFFSET)) {
      return objection(
          "The place is %.2f m from the leader; it must be from %.2f to %.0f m.",
          away, config.footprint() / 2, LARGEST_OFFSET);
    }
    return objectionToTolerance(follow.tolerance()).or(() -> objectionTo(follow.carries()));
  }

  private Optional<String> objectionToFingerprint(String robot, @Nullable String fingerprint) {
    if (fingerprint == null) {
      return Optional.empty();
    }
    if (Fingerprint.parse(fingerprint).isEmpty()) {
      return objection("The fingerprint of %s is null or has 64 digits 0-9a-f.", robot);
    }
    return encrypted
        ? Optional.empty()
        : objection("%s is not paired, so it cannot speak encrypted to %s.", config.name(), robot);
  }

  private static Optional<String> objectionToTolerance(double tolerance) {
    return tolerance > 0 && tolerance <= LARGEST_TOLERANCE
        ? Optional.empty()
        : objection(
            "The tolerance must be more than 0 and at most %.1f m, not %.3f.",
            LARGEST_TOLERANCE, tolerance);
  }

  private static Optional<String> objectionTo(@Nullable CarriedPart part) {
    if (part == null) {
      return Optional.empty();
    }
    if (!(part.share() > 0 && part.share() <= part.load())) {
      return objection(
          "The share must be more than 0 and at most the load of %.1f kg, not %.3f kg.",
          part.load(), part.share());
    }
    return part.point().norm() <= LARGEST_OFFSET && part.middle().norm() <= FARTHEST_LOAD
        ? Optional.empty()
        : objection("The load is too far away to be held.");
  }

  @FormatMethod
  private static Optional<String> objection(String sentence, Object... values) {
    return Optional.of(String.format(Locale.ROOT, sentence, values));
  }
}
