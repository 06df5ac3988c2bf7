package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.toqa.telemetry.Reading;
import org.toqa.telemetry.ReadingBoard.Presence;
import org.toqa.telemetry.ReadingBoard.RobotReadings;
import org.toqa.telemetry.ReadingLimits;
import org.toqa.telemetry.Telemetry;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.ReadingLimitsReader;

/** What a robot publishes by MQTT, its limits, and the password by which it does. */
public final class ReadingsResource extends ApiHandler {

  /**
   * @param user by whose name the robot publishes
   * @param connection null: its client has not said it
   * @param passedOver how many of its messages were not believed, by the reason, since the start
   */
  private record ReadingsJson(
      String robot,
      String broker,
      String user,
      @Nullable ConnectionJson connection,
      List<ReadingJson> readings,
      List<LimitsJson> limits,
      Map<String, Long> passedOver) {}

  private record ConnectionJson(boolean online, Instant since) {
    static @Nullable ConnectionJson of(@Nullable Presence presence) {
      return presence == null ? null : new ConnectionJson(presence.online(), presence.since());
    }
  }

  /**
   * @param age seconds since it was received
   */
  private record ReadingJson(
      String name, List<Double> values, String unit, long stamp, Instant receivedAt, double age) {
    static ReadingJson of(Reading reading, Instant now) {
      return new ReadingJson(
          reading.name(),
          reading.values(),
          reading.unit(),
          reading.stamp(),
          reading.receivedAt(),
          Math.max(0, Duration.between(reading.receivedAt(), now).toMillis()) / 1e3);
    }
  }

  private record LimitsJson(String reading, @Nullable Double low, @Nullable Double high) {
    static LimitsJson of(ReadingLimits limits) {
      return new LimitsJson(limits.reading(), limits.low(), limits.high());
    }
  }

  private record LoginJson(String broker, String user, String password) {}

  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    send(request, response, RobotResource.robot(request).name());
  }

  public static void setLimits(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String robot = RobotResource.robot(request).name();
    Telemetry telemetry = telemetry(request);
    String reading = RequestPath.parameter(request, "reading");
    telemetry.setLimits(
        readBody(request, fields -> ReadingLimitsReader.read(robot, reading, fields)));
    send(request, response, robot);
  }

  public static void makePassword(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String robot = RobotResource.robot(request).name();
    Telemetry telemetry = telemetry(request);
    if (!telemetry.broker().isEmbedded()) {
      throw Problem.of(409, Texts.of(request).get("problem.mqttElsewhere")).exception();
    }
    Telemetry.Login login = telemetry.makePassword(robot, Caller.of(request).name());
    Json.send(
        request,
        response,
        200,
        new LoginJson(telemetry.broker().address(), login.user(), login.password()));
  }

  private static void send(HttpServletRequest request, HttpServletResponse response, String robot)
      throws IOException {
    Telemetry telemetry = telemetry(request);
    RobotReadings known = telemetry.readings(robot);
    Instant now = services(request).clock().instant();
    Map<String, Long> passedOver = new TreeMap<>();
    known.refusals().forEach((why, count) -> passedOver.put(why.word(), count));
    Json.send(
        request,
        response,
        200,
        new ReadingsJson(
            robot,
            telemetry.broker().address(),
            telemetry.user(robot),
            ConnectionJson.of(known.presence()),
            known.readings().stream().map(reading -> ReadingJson.of(reading, now)).toList(),
            telemetry.limits(robot).stream().map(LimitsJson::of).toList(),
            passedOver));
  }

  private static Telemetry telemetry(HttpServletRequest request) {
    return Optional.ofNullable(services(request).telemetry())
        .orElseThrow(() -> Problem.of(404, Texts.of(request).get("problem.noMqtt")).exception());
  }
}
