package org.toqa.lab.experiment;

/** A run was stopped before its end, so there is no report. */
public final class RunStoppedException extends RuntimeException {
  private static final long serialVersionUID = 1;

  RunStoppedException() {
    super("The run was stopped before its end.");
  }
}
