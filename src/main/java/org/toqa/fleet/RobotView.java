package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.trust.Fingerprint;
import org.toqa.mission.Phase;
import org.toqa.wording.Sentence;

/**
 * A robot as readers see it.
 *
 * @param pose map frame; null while it was never heard of, and after a person said that it does not
 *     stand there any more
 * @param battery 0 to 1; null while it was never heard of
 * @param task the task it works for, if any
 * @param phase of its task that it is in
 * @param footprint diameter in metres
 * @param speed metres a second at which it drives straight on
 * @param path the rest of its path as a line, metres, map frame; empty when it stands
 * @param released how many points of {@code path} it may already drive to
 * @param held whether it shall hold: by a person's word, for its task, or since all are paused
 * @param charger the charging point that it charges at, drives to or waits for; null: none
 * @param fingerprint of the certificate that pairing recorded; null: the link is not encrypted
 * @param alert why it and the server do not trust each other; null: nothing is wrong
 */
public record RobotView(
    String name,
    String floor,
    RobotState state,
    @Nullable Pose pose,
    @Nullable Double battery,
    @Nullable Long task,
    Phase phase,
    double maxLoad,
    double footprint,
    double speed,
    String host,
    int port,
    @Nullable String parking,
    boolean simulated,
    List<Vec2> path,
    int released,
    List<Fault> errors,
    Sentence doing,
    @Nullable Instant lastSeen,
    boolean held,
    @Nullable String charger,
    @Nullable Fingerprint fingerprint,
    @Nullable Sentence alert) {

  public RobotView {
    path = List.copyOf(path);
    errors = List.copyOf(errors);
  }
}
