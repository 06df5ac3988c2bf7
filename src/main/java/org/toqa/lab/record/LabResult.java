package org.toqa.lab.record;

import java.util.List;

/**
 * What a run has given.
 *
 * @param report by {@link ReportJson}
 */
public record LabResult(String report, List<KeptDrawing> drawings) {
  public LabResult {
    drawings = List.copyOf(drawings);
  }
}
