package org.toqa.lab.record;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.toqa.lab.experiment.Figure;
import org.toqa.lab.experiment.Table;

/**
 * What is kept of a report beside its drawings.
 *
 * @param parameters all of the experiment with the values of the run, in their order
 */
public record KeptReport(
    Map<String, Double> parameters, List<Figure> figures, List<Table> tables, List<String> notes) {

  public KeptReport {
    parameters = Collections.unmodifiableMap(new LinkedHashMap<>(parameters));
    figures = List.copyOf(figures);
    tables = List.copyOf(tables);
    notes = List.copyOf(notes);
  }
}
