package org.toqa.web.api;

import java.time.Instant;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.toqa.lab.record.LabRun;
import org.toqa.lab.record.LabRunState;
import org.toqa.lab.record.Laboratory;

/**
 * A run of the laboratory.
 *
 * @param parameters that were set
 * @param detail why it failed, in English; null: it has not
 * @param progress null: it does not run now
 */
record LabRunJson(
    long id,
    String experiment,
    long seed,
    int runs,
    Map<String, Double> parameters,
    String user,
    Instant orderedAt,
    @Nullable Instant startedAt,
    @Nullable Instant endedAt,
    LabRunState state,
    @Nullable String detail,
    Laboratory.@Nullable Progress progress) {

  static LabRunJson of(LabRun run, Laboratory laboratory) {
    return new LabRunJson(
        run.id(),
        run.order().experiment(),
        run.order().seed(),
        run.order().runs(),
        run.order().values(),
        run.user(),
        run.orderedAt(),
        run.startedAt(),
        run.endedAt(),
        run.state(),
        run.detail(),
        laboratory.progress(run.id()).orElse(null));
  }
}
