package org.toqa.lab.experiment;

import java.util.List;
import org.toqa.lab.drawing.Drawing;

/**
 * What an experiment answers with.
 *
 * @param figures every published figure, beside ours
 * @param tables what else was measured
 * @param drawings charts and scenes, with names that no two of them share
 * @param notes what a reader must know beside them: sentences, such as that an input is ours
 */
public record Report(
    List<Figure> figures, List<Table> tables, List<Drawing> drawings, List<String> notes) {

  public Report {
    figures = List.copyOf(figures);
    tables = List.copyOf(tables);
    drawings = List.copyOf(drawings);
    notes = List.copyOf(notes);
  }
}
