package org.toqa.endtoend;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.toqa.endtoend.Work.Kind;

/**
 * What people want and what goes wrong in one run; the same seed gives the same plan.
 *
 * @param first work before anything goes wrong
 * @param imported begins at the moment of the first fault
 */
record CrashPlan(int seed, List<Work> first, Work imported, List<Step> steps) {
  private static final int FAULTS = 3;

  /** Each has its turn in three runs. */
  private static final List<Kind> BEFORE =
      List.of(
          Kind.TASK_HOLD,
          Kind.SCHEDULE,
          Kind.ROBOT_HOLD,
          Kind.FAULTY_IMPORT,
          Kind.PAUSE,
          Kind.CANCEL,
          Kind.FLOOR_HOLD,
          Kind.PUBLICATION,
          Kind.IMPOSSIBLE_DELIVERY);

  private static final List<Kind> DURING =
      List.of(Kind.DELIVERY, Kind.TEAM_DELIVERY, Kind.SCHEDULE, Kind.CANCEL, Kind.FAULTY_IMPORT);

  /**
   * @param before work before the fault; a hold lasts through it
   * @param during work while it lasts
   */
  record Step(Work before, Fault fault, Work during) {}

  static CrashPlan of(int seed) {
    Random random = new Random(seed);
    List<Fault> faults = Fault.random(FAULTS, random);
    List<Work> first =
        List.of(Work.random(Kind.DELIVERY, random), Work.random(Kind.TEAM_DELIVERY, random));
    Work imported = Work.random(Kind.IMPORT, random);
    List<Step> steps = new ArrayList<>();
    for (Fault fault : faults) {
      steps.add(
          new Step(
              Work.random(BEFORE.get((FAULTS * seed + steps.size()) % BEFORE.size()), random),
              fault,
              Work.random(DURING.get(random.nextInt(DURING.size())), random)));
    }
    return new CrashPlan(seed, first, imported, steps);
  }

  /** What the run's tasks are called; no other run's tasks are called so. */
  String prefix() {
    return "run" + seed + ".";
  }

  @Override
  public String toString() {
    return "seed "
        + seed
        + ": "
        + String.join(
            "; ",
            steps.stream()
                .map(step -> step.before() + ", " + step.fault() + ", " + step.during())
                .toList());
  }
}
