package org.toqa.web;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotView;
import org.toqa.network.DeviceAnswer;
import org.toqa.network.DeviceOrder;
import org.toqa.network.Ipv4Address;
import org.toqa.network.KnownRobot;
import org.toqa.network.Network;
import org.toqa.network.NetworkEntry;

/** The devices of a site's network, with the robots of its fleet. */
public final class NetworkDevices {
  private final Services services;

  public NetworkDevices(Services services) {
    this.services = services;
  }

  public Network network() {
    return services.network();
  }

  /** Robots first, then other devices by their names, then who is unknown. */
  public List<NetworkEntry> entries() {
    return network().entries(robots());
  }

  /**
   * @param by a user's name
   */
  public DeviceAnswer add(DeviceOrder order, String by) {
    return network().add(order, robots(), by);
  }

  /** The same for a device that is there. */
  public DeviceAnswer change(long id, DeviceOrder order, String by) {
    return network().change(id, order, robots(), by);
  }

  private List<KnownRobot> robots() {
    return services.fleet().snapshots().latest().robots().stream()
        .map(NetworkDevices::known)
        .toList();
  }

  private static KnownRobot known(RobotView robot) {
    RobotRecord record = robot.record();
    boolean isBehindGateway = record.gateway() != null;
    return new KnownRobot(
        record.name(),
        isBehindGateway ? record.gateway() + "/" + record.host() : record.host(),
        isBehindGateway || record.simulated()
            ? null
            : Ipv4Address.parse(record.host()).orElse(null),
        isReachable(robot),
        robot.telemetry().lastSeen());
  }

  /** Null: it has not been tried yet. */
  private static @Nullable Boolean isReachable(RobotView robot) {
    return switch (robot.state()) {
      case LOST -> false;
      case CONNECTING -> robot.unreachable() == null ? null : false;
      default -> robot.unreachable() == null;
    };
  }
}
