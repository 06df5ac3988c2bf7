package org.toqa.web.input;

import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.PairingOrder;
import org.toqa.fleet.RobotChange;
import org.toqa.fleet.RobotMove;
import org.toqa.fleet.RobotOrder;
import org.toqa.fleet.RobotOrder.HttpAccess;
import org.toqa.geometry.Pose;
import org.toqa.link.http.RobotToken;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.PairingCode;

/**
 * Reads what a manager orders for a robot. What it reads means something only where no sentence was
 * filed.
 */
public final class RobotOrderReader {
  private RobotOrderReader() {}

  public static RobotOrder readOrder(Fields fields) {
    InputRules rules = fields.rules();
    RobotOrder order =
        new RobotOrder(
            rules.robotName("name", fields.text("name")),
            rules.host("host", fields.text("host")),
            rules.port("port", fields.number("port")),
            rules.load("maxLoad", fields.number("maxLoad")),
            fields.text("parking"),
            rules.pairingCode("code", fields.text("code")),
            rules.gateway("gateway", fields.text("gateway")),
            fields.text("floor"),
            readHttp(fields));
    fields.refuseUnknown();
    return order;
  }

  /** Null where the robot speaks the robot link; a form has the fields of both. */
  private static @Nullable HttpAccess readHttp(Fields fields) {
    InputRules rules = fields.rules();
    String link = fields.text("link");
    String token = fields.text("token");
    String fingerprint = fields.text("fingerprint");
    boolean isHttp =
        rules.isHttp("link", link == null && (token != null || fingerprint != null) ? "" : link);
    if (!isHttp) {
      return null;
    }
    RobotToken read = rules.robotToken("token", token == null ? "" : token);
    Fingerprint certificate = rules.fingerprint("fingerprint", fingerprint);
    return read == null ? null : new HttpAccess(read, certificate);
  }

  public static RobotChange readChange(Fields fields) {
    InputRules rules = fields.rules();
    RobotChange change =
        new RobotChange(
            rules.host("host", fields.text("host")),
            rules.port("port", fields.number("port")),
            rules.load("maxLoad", fields.number("maxLoad")),
            fields.text("parking"),
            rules.gateway("gateway", fields.text("gateway")),
            rules.robotToken("token", fields.text("token")),
            rules.fingerprint("fingerprint", fields.text("fingerprint")));
    fields.refuseUnknown();
    return change;
  }

  /** The codes of the stops that a person was shown and clears. */
  public static Set<String> readReasons(Fields fields) {
    Set<String> reasons = Set.copyOf(fields.choices("reasons"));
    if (reasons.isEmpty()) {
      fields.errors().add(fields.path("reasons"), fields.texts().get("error.reasons.missing"));
    }
    fields.refuseUnknown();
    return reasons;
  }

  /** Where a robot is, with its heading {@code theta} in radians. */
  public static Pose readPosition(Fields fields) {
    Pose pose = readPose(fields);
    fields.refuseUnknown();
    return pose;
  }

  /** The same where other fields follow. */
  public static Pose readPose(Fields fields) {
    InputRules rules = fields.rules();
    return new Pose(
        rules.coordinateOfPose("x", fields.number("x")),
        rules.coordinateOfPose("y", fields.number("y")),
        rules.angle("theta", fields.number("theta")));
  }

  /** As a form has it: its {@code heading} in degrees. */
  public static Pose readEnteredPose(Fields fields) {
    InputRules rules = fields.rules();
    return new Pose(
        rules.coordinateOfPose("x", fields.number("x")),
        rules.coordinateOfPose("y", fields.number("y")),
        Math.toRadians(rules.angle("heading", fields.number("heading"))));
  }

  /**
   * To which floor a robot was carried, and where it stands there.
   *
   * @param pose reads where
   */
  public static RobotMove readMove(Fields fields, Function<Fields, Pose> pose) {
    String floor = fields.text("floor");
    if (floor == null) {
      fields.errors().add(fields.path("floor"), fields.texts().get("error.floor.missing"));
    }
    RobotMove move = new RobotMove(floor == null ? "" : floor, pose.apply(fields));
    fields.refuseUnknown();
    return move;
  }

  /** What pairs a robot that is known; empty where a sentence was filed. */
  public static Optional<PairingOrder> readPairing(Fields fields) {
    String givenHost = fields.text("host");
    Double givenPort = fields.number("port");
    String givenCode = fields.text("code");
    InputRules rules = fields.rules();
    String host = rules.host("host", givenHost);
    int port = rules.port("port", givenPort);
    PairingCode code = rules.pairingCode("code", givenCode == null ? "" : givenCode);
    fields.refuseUnknown();
    return code == null || !fields.errors().isEmpty()
        ? Optional.empty()
        : Optional.of(new PairingOrder(host, port, code));
  }
}
