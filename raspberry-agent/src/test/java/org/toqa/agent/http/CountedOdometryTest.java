package org.toqa.agent.http;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.http.CountedOdometry.Outcome;
import org.toqa.link.http.RobotDescription;
import org.toqa.link.http.WheelReport;

/** Which counts are believed, whenever they come. */
class CountedOdometryTest {
  private static final double MAX_SPEED = 0.5;
  private static final double WHEEL_RADIUS = 0.05;
  private static final int COUNTS_PER_TURN = 1000;
  private static final double METRES_PER_COUNT = 2 * Math.PI * WHEEL_RADIUS / COUNTS_PER_TURN;
  private static final long BOOT = 7;
  private static final RobotDescription BODY =
      new RobotDescription(
          0.2, WHEEL_RADIUS, COUNTS_PER_TURN, MAX_SPEED, 5, 0.25, false, List.of(), null, BOOT, 0);

  @TempDir private Path folder;
  private CountedOdometry odometry;

  @BeforeEach
  void begin() throws IOException {
    odometry = open();
    assertEquals(Outcome.BEGUN_ANEW, odometry.update(report(0), ms(0), ms(2)));
  }

  @AfterEach
  void close() {
    odometry.close();
  }

  @Test
  void drivenAtFullSpeedItIsBelieved() {
    for (int answer = 1; answer <= 100; answer++) {
      double driven = MAX_SPEED * 0.03 * answer;
      long asked = ms(30L * answer);
      assertEquals(
          Outcome.CONTINUED, odometry.update(report(driven), asked, asked + ms(2)), "" + answer);
    }
    assertEquals(1.5, odometry.pose().x(), 0.001);
    assertEquals(MAX_SPEED, odometry.twist().vx(), 0.01);
  }

  /** Its counts were read soon after it was asked for, and those of the next one just before. */
  @Test
  void answerThatWasHeldUpMakesTheNextNoJump() {
    assertEquals(Outcome.CONTINUED, odometry.update(report(0.01), ms(30), ms(330)));
    assertEquals(Outcome.CONTINUED, odometry.update(report(0.01 + 0.15), ms(331), ms(333)));
  }

  /** It drove by them all the same. */
  @Test
  void answersThatWereLostMakeTheNextNoJump() {
    for (int order = 1; order <= 10; order++) {
      odometry.miss(ms(200L * order));
    }
    assertEquals(Outcome.CONTINUED, odometry.update(report(1), ms(2_100), ms(2_102)));
    assertEquals(Outcome.JUMPED, odometry.update(report(2), ms(2_130), ms(2_132)));
  }

  @Test
  void moreThanWheelsCanTurnIsAJump() {
    assertEquals(Outcome.CONTINUED, odometry.update(report(0.01), ms(30), ms(32)));
    assertEquals(Outcome.JUMPED, odometry.update(report(0.01 + 0.07), ms(60), ms(62)));
  }

  /** Nor does it matter how long nobody asked: it has stopped by itself meanwhile. */
  @Test
  void moreThanItTakesToStopIsAJumpAlsoAfterAnHour() throws IOException {
    double stop = 1.5 * MAX_SPEED * 0.6;
    odometry.close();
    odometry = open();
    assertEquals(Outcome.CONTINUED, odometry.update(report(stop), ms(10), ms(12)));
    assertEquals(
        Outcome.JUMPED, odometry.update(report(stop + stop + 0.05), ms(3_600_000), ms(3_600_002)));
  }

  private CountedOdometry open() throws IOException {
    return new CountedOdometry(folder.resolve("odometry"), BODY);
  }

  private static long ms(long milliseconds) {
    return milliseconds * 1_000_000;
  }

  /**
   * @param driven metres straight on
   */
  private static WheelReport report(double driven) {
    long counts = Math.round(driven / METRES_PER_COUNT);
    return new WheelReport(1, BOOT, 0, counts, counts, null, null, List.of());
  }
}
