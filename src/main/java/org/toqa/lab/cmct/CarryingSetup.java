package org.toqa.lab.cmct;

import java.util.List;
import org.toqa.cooperation.CarryRules;
import org.toqa.lab.experiment.Parameter;
import org.toqa.lab.experiment.Run;
import org.toqa.planning.PathPlanner;

/**
 * How boxes are carried.
 *
 * @param isSupervised with a supervisor, or by workers that see and choose for themselves
 * @param speed m/s, of all
 * @param range metres that cameras see
 * @param look seconds that it takes to make out a box that is seen
 * @param handling seconds to take a box, or to set it down; a weighing is in it
 * @param endurance seconds of driving that a full battery lasts
 * @param charging seconds from empty to full
 * @param nearest D_s, metres between the middles of two robots
 */
record CarryingSetup(
    boolean isSupervised,
    PathPlanner planner,
    CarryRules rules,
    double speed,
    double range,
    double look,
    double handling,
    double endurance,
    double charging,
    double nearest) {

  static final Parameter SPEED = new Parameter("speed", 1, 0.1, 5, "m/s", "of all robots");
  static final Parameter RANGE = new Parameter("range", 25, 5, 150, "m", "that cameras see");
  static final Parameter LOOK =
      new Parameter("look", 10, 0, 300, "s", "to make out a box that is seen");
  static final Parameter HANDLING =
      new Parameter("handling", 5, 0, 300, "s", "to take a box, and to set it down");
  static final Parameter THRESHOLD =
      new Parameter("threshold", 5, 0.1, 100, "kg", "that one worker carries alone");
  static final Parameter ENDURANCE =
      new Parameter("endurance", 1200, 100, 1e6, "s", "of driving that a battery lasts");
  static final Parameter CHARGING =
      new Parameter("charging", 300, 1, 1e5, "s", "from empty to full");
  static final Parameter NEAREST =
      new Parameter("nearest", 5, 4, 8, "m", "D_s, between the middles of two robots");

  static final List<Parameter> PARAMETERS =
      List.of(SPEED, RANGE, LOOK, HANDLING, THRESHOLD, ENDURANCE, CHARGING, NEAREST);

  /** A battery below this is low. */
  private static final double LOW = 0.25;

  static CarryingSetup of(Run run, boolean isSupervised, boolean overlaps, PathPlanner planner) {
    return new CarryingSetup(
        isSupervised,
        planner,
        new CarryRules(run.value(THRESHOLD), LOW, CarryRules.WORK_TIME, overlaps),
        run.value(SPEED),
        run.value(RANGE),
        run.value(LOOK),
        run.value(HANDLING),
        run.value(ENDURANCE),
        run.value(CHARGING),
        run.value(NEAREST));
  }
}
