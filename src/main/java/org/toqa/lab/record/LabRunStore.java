package org.toqa.lab.record;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Where runs are kept. All methods throw {@link org.toqa.persistence.StoreException} when the
 * database does not answer.
 */
public interface LabRunStore {
  /** Queues a run. */
  LabRun add(LabOrder order, String user, Instant at);

  /** All, the newest first. */
  List<LabRun> runs();

  Optional<LabRun> run(long id);

  /** Of a run that is done. */
  Optional<String> report(long id);

  /** In the order in which the experiment made them. */
  List<KeptDrawing.Entry> drawings(long id);

  Optional<KeptDrawing> drawing(long id, String name);

  /** A run that waited goes on to run; false: it waits no more. */
  boolean begin(long id, Instant at);

  /**
   * A run that is not over ends without a report; false: it was over.
   *
   * @param state in which it ends
   */
  boolean end(long id, LabRunState state, @Nullable String detail, Instant at);

  /** A run ends with what it has given. */
  void complete(long id, LabResult result, Instant at);

  /** Those that ran when the server ended are broken off. */
  void breakOff(Instant at);

  /** A run that is over goes, with all that is kept of it; false: it is not over, or not there. */
  boolean delete(long id);
}
