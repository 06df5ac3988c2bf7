package org.toqa.lab.csm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.geometry.Vec2;
import org.toqa.lab.experiment.Figure;
import org.toqa.lab.experiment.Report;
import org.toqa.lab.experiment.Run;
import org.toqa.lab.experiment.RunStoppedException;
import org.toqa.lab.experiment.Value;
import org.toqa.lab.experiment.Verdict;
import org.toqa.planning.exact.ShortestDiscPath;
import org.toqa.planning.smooth.DiscSpace;
import org.toqa.planning.smooth.SmoothMethod;
import org.toqa.planning.smooth.curve.SmoothCurve;
import org.toqa.planning.smooth.curve.SplineFitter;

@Tag("full")
class CsmExperimentsTest {
  private static final double RADIUS = 0.1;

  /** By the answers' pose, with 40 ms delay. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void aRobotStaysOnItsPathByItsAnswers(int number) {
    CsmFloor floor = CsmFloor.read(number);
    DiscSpace space = DiscSpace.of(floor.grid(), RADIUS);
    PlannedPath planned = PlannedPath.of(SmoothMethod.HYBRID, space, floor, 2000, number);
    SmoothCurve curve =
        new SplineFitter(space).fit(Objects.requireNonNull(planned.path()).points());

    StaticDrive drive = StaticDrive.of("path", curve.pieces(), floor, Run.of(1, 1), number);

    assertTrue(drive.positionError() < 0.015, "metres: " + drive.positionError());
    assertTrue(drive.aside() < 0.015, "metres beside its curve: " + drive.aside());
    assertTrue(drive.orientationError() < 0.1, "radians: " + drive.orientationError());
    assertTrue(drive.wheelSpeed() <= 0.52 + 1e-12);
    assertTrue(drive.trueError() > drive.positionError(), "slip is not seen by wheel counts");
    assertTrue(drive.trueErrorWithRanges() < 0.015, "metres: " + drive.trueErrorWithRanges());
    Vec2 end = drive.drive().body().answer().position();
    assertEquals(0, end.distanceTo(floor.goal()), 0.005);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void noPathIsShorterThanTheShortest(int number) {
    CsmFloor floor = CsmFloor.read(number);
    OptionalDouble shortest =
        new ShortestDiscPath(floor.grid(), RADIUS).length(floor.start(), floor.goal());
    DiscSpace space = DiscSpace.of(floor.grid(), RADIUS);
    for (SmoothMethod method : SmoothMethod.values()) {
      PlannedPath planned = PlannedPath.of(method, space, floor, 1000, 1);
      double over = planned.centimetres() / 100 - shortest.orElseThrow();
      assertTrue(over > -1e-6 && over < 0.1, method + " is longer by " + over);
    }
  }

  /** So that the layout, which is ours, is no worse than the one that the paper had. */
  @Test
  void theCurvesOfThePaperAreFreeOnOurFloors() {
    assertFree(PublishedCurve.EQUATION_9, 1);
    assertFree(PublishedCurve.EQUATION_10, 1);
    assertFree(PublishedCurve.EQUATION_13, 2);
    assertFree(PublishedCurve.EQUATION_14, 3);
  }

  private static void assertFree(PublishedCurve curve, int floor) {
    DiscSpace space = DiscSpace.of(CsmFloor.read(floor).grid(), RADIUS);
    for (int i = 1; i <= 500; i++) {
      Vec2 from = curve.position(curve.end() * (i - 1) / 500);
      Vec2 to = curve.position(curve.end() * i / 500);
      assertTrue(space.isFree(from, to), "floor " + floor + " at " + from);
    }
  }

  @Test
  void aPublishedCurveIsItsPolynomialWithItsDerivatives() {
    PublishedCurve curve = PublishedCurve.EQUATION_14;
    // 0.0034 * 100^2 - 0.64 * 100 + 157.53 = 127.53
    assertEquals(127.53, curve.y(100), 1e-9);
    double h = 1e-4;
    for (double u = 1; u < curve.end(); u += 1.7) {
      Vec2 slope = curve.position(u + h).minus(curve.position(u - h)).times(1 / (2 * h));
      assertEquals(0, slope.distanceTo(curve.velocity(u)), 1e-6);
      Vec2 bend = curve.velocity(u + h).minus(curve.velocity(u - h)).times(1 / (2 * h));
      assertEquals(0, bend.distanceTo(curve.acceleration(u)), 1e-6);
    }
  }

  @Test
  void robotsDriveRoundMovingObstaclesWithoutContact() {
    Run run = new Run(2, 1, Map.of("scenes", 6.0), (share, step) -> {}, () -> false);
    Report report = new CsmDynamic().run(run);

    for (String robot : List.of("robot 1", "robot 2")) {
      Figure figure = named(report, robot + ": reaches its goal without contact");
      assertEquals(Verdict.REPRODUCED, figure.verdict(), figure::toString);
    }
    Figure contacts = named(report, "contacts by its own motion, in scenes of chance");
    assertEquals(Value.of("0 of 6"), contacts.measured());
    List<String> drives = report.tables().getFirst().rows().getFirst();
    assertEquals("1", drives.get(3), "robot 1 takes one detour");
    for (List<String> row : report.tables().getFirst().rows()) {
      double inTruth = Double.parseDouble(row.get(6));
      double withRanges = Double.parseDouble(row.get(7));
      assertTrue(withRanges < 1.5 && withRanges < inTruth / 2, row::toString);
      assertTrue(Double.parseDouble(row.get(9)) > 0, row::toString);
    }
  }

  @Test
  void theSumsOfThePaperAreThoseOfItsRows() {
    Run run =
        new Run(1, 1, Map.of("robots", 5.0, "samples", 10.0), (share, step) -> {}, () -> false);
    Report report = new CsmBudget().run(run);

    for (String table : List.of("table II, three", "table III, one", "table IV, two")) {
      Figure figure =
          report.figures().stream()
              .filter(f -> f.name().startsWith(table))
              .findFirst()
              .orElseThrow();
      assertEquals(Verdict.REPRODUCED, figure.verdict(), figure::toString);
    }
  }

  @Test
  void aRunThatIsStoppedEndsWithoutAReport() {
    Run run = new Run(1, 1, Map.of(), (share, step) -> {}, () -> true);

    assertThrows(RunStoppedException.class, () -> new CsmStatic().run(run));
    assertThrows(RunStoppedException.class, () -> new CsmDynamic().run(run));
    assertThrows(RunStoppedException.class, () -> new CsmBudget().run(run));
  }

  @Test
  void everyFigureThatIsNotComparableSaysWhichInputIsMissing() {
    Report report = new CsmStatic().run(Run.of(1, 1));

    for (Figure figure : report.figures()) {
      assertFalse(
          figure.verdict() == Verdict.NOT_COMPARABLE && figure.reason().isEmpty(),
          figure::toString);
    }
  }

  private static Figure named(Report report, String name) {
    return report.figures().stream().filter(f -> f.name().equals(name)).findFirst().orElseThrow();
  }
}
