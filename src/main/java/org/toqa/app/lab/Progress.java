package org.toqa.app.lab;

import org.toqa.app.command.CommandOutput;
import org.toqa.lab.experiment.Run.ProgressListener;

/** Prints how far a run is to standard error: a line for each step. */
record Progress(String experiment, CommandOutput output) implements ProgressListener {

  @Override
  public void progress(double share, String step) {
    output.printError("%s: %d %%, %s".formatted(experiment, Math.round(100 * share), step));
  }
}
