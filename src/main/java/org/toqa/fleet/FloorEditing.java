package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorMap;

/**
 * How floors come to be, change and go.
 *
 * <ol>
 *   <li>A floor is added with a drawing, which is in force at once: nobody drives there yet.
 *   <li>A draft is saved beside what is in force, as often as one likes; whoever has not seen the
 *       last change of it changes nothing.
 *   <li>The draft is checked and published: it is in force from then on, for all robots, and the
 *       draft is gone.
 * </ol>
 *
 * Any thread may call it. A stage fails only when the store does not answer.
 */
public interface FloorEditing {

  /** A new floor, the last of all. */
  CompletionStage<Answer<FloorMap>> addFloor(String name, FloorDrawing drawing, String user);

  /** Removes a floor that has no robots and no open tasks; the history keeps it. */
  CompletionStage<Answer<String>> removeFloor(String floor, String user);

  /** The floor's draft, or what is in force where there is none; empty: no such floor. */
  Optional<FloorDraft> draft(String floor);

  /**
   * @param seen the revision that the user has changed; outdated if there is another one by now
   */
  CompletionStage<Answer<FloorDraft>> saveDraft(
      String floor, FloorDrawing drawing, long seen, String user);

  /**
   * Forgets the draft; nothing is wrong where there is none.
   *
   * @param seen the revision that the user has seen, outdated if there is another one by now; null:
   *     whichever there is
   */
  CompletionStage<Answer<FloorDraft>> discardDraft(String floor, @Nullable Long seen, String user);

  /** What publishing this drawing would meet; nothing is stored. */
  CompletionStage<Answer<List<MapProblem>>> check(String floor, FloorDrawing drawing, String user);

  /**
   * Puts the draft in force; it is refused where a problem is blocking.
   *
   * @param seen the revision that is to be published; outdated if there is another one by now
   */
  CompletionStage<Answer<FloorMap>> publish(String floor, long seen, String user);

  /** The map that was in force then; empty: there was none, or no such floor. */
  Optional<FloorMap> mapAt(String floor, Instant at);
}
