package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import org.toqa.lab.Experiments;
import org.toqa.lab.experiment.Experiment;
import org.toqa.lab.experiment.Parameter;

/** The experiments of the laboratory. */
public final class LabExperimentsResource extends ApiHandler {
  /**
   * @param title in English, as everything that an experiment says
   */
  private record ExperimentJson(
      String name, String title, String source, List<Parameter> parameters) {
    static ExperimentJson of(Experiment experiment) {
      return new ExperimentJson(
          experiment.name(), experiment.title(), experiment.source(), experiment.parameters());
    }
  }

  public static void list(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Json.send(request, response, 200, Experiments.all().stream().map(ExperimentJson::of).toList());
  }
}
