package org.toqa.lab;

import java.util.List;
import java.util.Optional;
import org.toqa.lab.cmct.CmctCarrying;
import org.toqa.lab.cmct.CmctPlanning;
import org.toqa.lab.csm.CsmBudget;
import org.toqa.lab.csm.CsmDynamic;
import org.toqa.lab.csm.CsmStatic;
import org.toqa.lab.experiment.Experiment;
import org.toqa.lab.fouragents.GeneratedScenes;
import org.toqa.lab.fouragents.PublishedScenes;
import org.toqa.lab.swarm.SwarmLimits;
import org.toqa.lab.swarm.SwarmSweep;

/** The experiments that there are, in the order of their names. */
public final class Experiments {
  private static final List<Experiment> ALL =
      List.of(
          new CmctPlanning(),
          new CmctCarrying(),
          new CsmBudget(),
          new CsmDynamic(),
          new CsmStatic(),
          new PublishedScenes(),
          new GeneratedScenes(),
          new SwarmSweep(),
          new SwarmLimits());

  private Experiments() {}

  public static List<Experiment> all() {
    return ALL;
  }

  /** The one of that name. */
  public static Optional<Experiment> named(String name) {
    return ALL.stream().filter(experiment -> experiment.name().equals(name)).findFirst();
  }
}
