package org.toqa.app.demo;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.toqa.agent.chassis.Surroundings;
import org.toqa.geometry.Pose;
import org.toqa.link.http.RobotDescription;
import org.toqa.telemetry.mqtt.ReadingPublisher;
import tools.jackson.databind.json.JsonMapper;

/**
 * Four ultrasonic sensors of a simulated robot, which look ahead, to both sides and back from its
 * rim: publishes ten times a second by MQTT what they measure, as {@code docs/telemetry.md} says.
 */
final class UltrasonicSensors implements AutoCloseable {
  /** Metres; what is farther is not seen. Standard deviation of the map from the floor, metres. */
  static final RobotDescription.Sonar SONAR = new RobotDescription.Sonar(4, 0.02);

  /** Radians, from right to left. */
  private static final List<Double> ANGLES = List.of(-Math.PI / 2, 0.0, Math.PI / 2, Math.PI);

  private static final long PERIOD_MILLIS = 100;

  private final ReadingPublisher publisher;
  private final Supplier<Pose> truth;
  private final double radius;
  private final Surroundings surroundings;
  private final CountDownLatch closing = new CountDownLatch(1);

  /**
   * @param stamp milliseconds since 1970
   * @param metres from right to left
   * @param angles of the sensors, radians
   */
  private record Ranges(long stamp, List<Double> metres, List<Double> angles) {}

  private UltrasonicSensors(
      ReadingPublisher publisher, Supplier<Pose> truth, double radius, Surroundings surroundings) {
    this.publisher = publisher;
    this.truth = truth;
    this.radius = radius;
    this.surroundings = surroundings;
  }

  /**
   * @param publisher is closed with these
   * @param truth where the robot really is, map frame
   * @param radius of the robot, metres
   */
  static UltrasonicSensors start(
      ReadingPublisher publisher, Supplier<Pose> truth, double radius, Surroundings surroundings) {
    UltrasonicSensors sensors = new UltrasonicSensors(publisher, truth, radius, surroundings);
    Thread.ofVirtual().name("ultrasonic").start(sensors::run);
    return sensors;
  }

  private void run() {
    try {
      while (!closing.await(PERIOD_MILLIS, TimeUnit.MILLISECONDS)) {
        publish();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void publish() {
    List<Double> metres = new ArrayList<>();
    Pose robot = truth.get();
    for (double angle : ANGLES) {
      Pose rim = new Pose(radius * Math.cos(angle), radius * Math.sin(angle), angle);
      metres.add(surroundings.distance(robot.compose(rim), SONAR.farthest()));
    }
    publisher.publish(
        "range",
        JsonMapper.shared()
            .writeValueAsString(new Ranges(System.currentTimeMillis(), metres, ANGLES)));
  }

  @Override
  public void close() {
    closing.countDown();
    publisher.close();
  }
}
