package org.toqa.web.page;

import org.jspecify.annotations.Nullable;
import org.toqa.lab.Experiments;
import org.toqa.lab.experiment.Experiment;
import org.toqa.lab.record.LabRun;
import org.toqa.lab.record.LabRunState;
import org.toqa.lab.record.Laboratory;

/**
 * A run as the pages show it.
 *
 * @param title of its experiment, in English
 * @param progress null: it does not run now
 */
public record LabRunView(LabRun run, String title, Laboratory.@Nullable Progress progress) {
  static LabRunView of(LabRun run, Laboratory laboratory) {
    return new LabRunView(
        run,
        Experiments.named(run.order().experiment())
            .map(Experiment::title)
            .orElse(run.order().experiment()),
        laboratory.progress(run.id()).orElse(null));
  }

  public boolean isOver() {
    return run.state().isOver();
  }

  public boolean isDone() {
    return run.state() == LabRunState.DONE;
  }
}
