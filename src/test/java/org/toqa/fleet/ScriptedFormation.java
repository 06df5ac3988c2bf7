package org.toqa.fleet;

import java.util.List;
import java.util.Objects;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Lead;

/** What a scripted robot is in a formation, and how it finds the others of it. */
final class ScriptedFormation {
  private Function<String, ScriptedRobot> peers;
  private @Nullable Lead leading;
  private @Nullable Follow following;

  /** Whether its followers go elsewhere after its next order to lead. */
  private boolean losesFollowers;

  /** The order by which it finds none of its followers; null: there is none. */
  private @Nullable Lead outdated;

  /** How often it has brought a formation to where that went; others read it. */
  private volatile int ends;

  /** How often its leader had, when it began to follow. */
  private int endsBefore;

  ScriptedFormation(Function<String, ScriptedRobot> peers) {
    this.peers = peers;
  }

  void setPeers(Function<String, ScriptedRobot> byName) {
    peers = byName;
  }

  void lead(Lead order) {
    leading = order;
    if (losesFollowers) {
      outdated = order;
      losesFollowers = false;
    }
  }

  void follow(Follow order) {
    following = order;
    endsBefore = leader().formation().ends;
  }

  /** By its next order to lead it finds none of its followers, by the one after that all. */
  void loseFollowers() {
    losesFollowers = true;
  }

  void cancel() {
    leading = null;
    following = null;
  }

  /** Its drive is at its goal, and with it the formation, if it leads one. */
  void endLeading() {
    ends += leading == null ? 0 : 1;
    leading = null;
  }

  void endFollowing() {
    following = null;
  }

  /** What it was told to follow; null while it follows nobody. */
  @Nullable Follow following() {
    return following;
  }

  ScriptedRobot leader() {
    return peers.apply(Objects.requireNonNull(following).leader());
  }

  boolean isFollowing(long task) {
    return following != null && following.task() == task;
  }

  /** Whether the formation that it follows is where that went. */
  boolean hasLeaderEnded() {
    return leader().formation().ends > endsBefore;
  }

  /** Those that it leads. */
  List<ScriptedRobot> followers() {
    Lead lead = leading;
    return lead == null
        ? List.of()
        : lead.followers().stream().map(follower -> peers.apply(follower.robot())).toList();
  }

  /** A follower that does not follow; null while all do, or it leads none. */
  @Nullable String missing() {
    Lead lead = leading;
    return lead == null
        ? null
        : lead.followers().stream()
            .map(ServerMessage.Follower::robot)
            .filter(
                follower -> lead == outdated || !peers.apply(follower).isKeepingPlace(lead.task()))
            .findFirst()
            .orElse(null);
  }

  /** Why it stands; null: it leads none, or that drives. */
  @Nullable String stopReason() {
    String missing = missing();
    return missing == null ? null : "The group has stopped: " + missing + " does not answer.";
  }

  Role role() {
    if (following != null) {
      return Role.FOLLOWER;
    }
    return leading == null ? Role.ALONE : Role.LEADER;
  }
}
