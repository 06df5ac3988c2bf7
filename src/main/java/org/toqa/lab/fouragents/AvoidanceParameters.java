package org.toqa.lab.fouragents;

import java.util.List;
import org.toqa.avoidance.fouragents.FourAgentsSettings;
import org.toqa.lab.experiment.Parameter;
import org.toqa.lab.experiment.Run;

/** What the paper, whose figures and tables are lost in our copy, leaves open. */
final class AvoidanceParameters {
  private static final FourAgentsSettings CHOSEN = SceneDrive.khepera();

  static final Parameter MARGIN =
      new Parameter(
          "margin",
          CHOSEN.margin(),
          0.005,
          0.1,
          "m",
          "air between robot and obstacle on the convergence circle");

  static final Parameter DANGER =
      new Parameter(
          "danger", CHOSEN.danger(), 0.01, 0.09, "m", "the dangerous zone; published as 50 mm");

  static final Parameter APPROACH =
      new Parameter(
          "approach",
          CHOSEN.approach(),
          0,
          0.1,
          "m",
          "over which static avoidance's utility rises outside the circle; 0: inside, as the"
              + " text has it");

  static final Parameter HYSTERESIS =
      new Parameter(
          "hysteresis", CHOSEN.hysteresis(), 0, 0.3, "", "by which another utility must be larger");

  static final Parameter NOISE =
      new Parameter(
          "noise", 0.01, 0, 0.2, "", "standard deviation of readings and wheels, a share");

  static final List<Parameter> ALL = List.of(MARGIN, DANGER, APPROACH, HYSTERESIS, NOISE);

  private AvoidanceParameters() {}

  static FourAgentsSettings settings(Run run) {
    return CHOSEN
        .withMargin(run.value(MARGIN))
        .withDanger(run.value(DANGER))
        .withApproach(run.value(APPROACH))
        .withHysteresis(run.value(HYSTERESIS));
  }
}
