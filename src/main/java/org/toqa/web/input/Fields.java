package org.toqa.web.input;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskOrder.StopOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.mission.ArmHandling;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.web.Texts;
import tools.jackson.databind.JsonNode;

/**
 * The fields of what somebody sent: a form, a JSON object or a line of a table. A field that is
 * empty counts as missing; one that is not of the kind that is asked for gets a sentence and counts
 * as missing.
 */
public interface Fields {

  @Nullable String text(String name);

  /** What was chosen of several; empty where nothing was. */
  List<String> choices(String name);

  @Nullable Double number(String name);

  /**
   * A moment as this kind of input writes it.
   *
   * @param errorKey of the sentence for what is no moment, where this kind of input has none of its
   *     own
   */
  @Nullable Instant moment(String name, String errorKey);

  /** A station or coordinates, as this kind of input writes them. */
  Where place(String name);

  /**
   * Several of them, in their order; empty where nobody wrote a list of places, or this kind of
   * input has none.
   *
   * @param max a longer list gets a sentence
   */
  default List<Where> places(String name, int max) {
    return List.of();
  }

  /**
   * Stops of a task, in their order, with what is waited for there; empty where nobody wrote any,
   * or this kind of input has none.
   *
   * @param max a longer list gets a sentence
   */
  default List<StopOrder> stops(String name, int max) {
    return List.of();
  }

  /** What is waited for at a place that this kind of input names by itself. */
  default StopOrder stopAt(String name, Where where) {
    return new StopOrder(where, false, null);
  }

  /** Both sides, or null where neither is given. */
  @Nullable LoadSize size(String name);

  /** Both places, or null where neither is given. */
  default @Nullable ArmHandling arm(String name) {
    return null;
  }

  /** Whether it was said; false where it is missing. */
  default boolean flag(String name) {
    return "true".equals(text(name));
  }

  /**
   * Where boxes shall lie, metres, map frame, by the numbers on them; empty where nobody wrote any,
   * or this kind of input has none.
   *
   * @param max a longer list gets a sentence
   */
  default Map<Integer, Vec2> boxTargets(String name, int max) {
    return Map.of();
  }

  /** The members of an object by their names, as JSON; none where this kind of input has none. */
  default Map<String, JsonNode> members(String name) {
    return Map.of();
  }

  Texts texts();

  /** Where the sentences are filed. */
  FieldErrors errors();

  default InputRules rules() {
    return new InputRules(texts(), errors());
  }

  default boolean has(String name) {
    return text(name) != null;
  }

  /** Whether anything of such a place is given. */
  default boolean hasPlace(String name) {
    return has(name);
  }

  /** The fields of an object in these; where no objects are written, these fields themselves. */
  default Fields object(String name) {
    return this;
  }

  /** The name under which sentences for that field are filed. */
  default String path(String name) {
    return name;
  }

  /** Files a sentence for each field that nobody asked for, where such a one is a mistake. */
  default void refuseUnknown() {}
}
