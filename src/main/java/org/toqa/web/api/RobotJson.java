package org.toqa.web.api;

import java.time.Instant;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.wording.Sentence;

/** A robot on the wire; the fields are those of {@link RobotView}, the route as it is drawn. */
public record RobotJson(
    String name,
    String floor,
    RobotState state,
    @Nullable Pose pose,
    @Nullable Double battery,
    @Nullable Long task,
    int phase,
    double maxLoad,
    double footprint,
    double speed,
    String host,
    int port,
    @Nullable String parking,
    boolean simulated,
    List<Vec2> route,
    int released,
    List<Fault> errors,
    Sentence doing,
    @Nullable Instant lastSeen,
    boolean held,
    @Nullable String charger,
    @Nullable String fingerprint,
    @Nullable Sentence alert) {

  public static RobotJson of(RobotView view) {
    SimplifiedPath path = SimplifiedPath.of(view.path(), view.released());
    return new RobotJson(
        view.name(),
        view.floor(),
        view.state(),
        view.pose(),
        view.battery(),
        view.task(),
        view.phase().number(),
        view.maxLoad(),
        view.footprint(),
        view.speed(),
        view.host(),
        view.port(),
        view.parking(),
        view.simulated(),
        path.points(),
        path.released(),
        view.errors(),
        view.doing(),
        view.lastSeen(),
        view.held(),
        view.charger(),
        Objects.toString(view.fingerprint(), null),
        view.alert());
  }
}
