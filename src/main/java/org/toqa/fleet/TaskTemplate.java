package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * An order of a task that is given again and again. Some of its fields are open: a parameter fills
 * each of them when a task is ordered.
 *
 * @param name none other has it, upper and lower case taken for the same
 * @param floor of its tasks
 * @param order a JSON object as the API takes an order, but without its floor; what stands in a
 *     field that a parameter fills goes for it where nothing else is said
 * @param shared whether everybody who may order tasks may use it, or its owner alone
 * @param user who made it
 * @param owner the id of his account; null: he is no user any more
 */
public record TaskTemplate(
    long id,
    String name,
    String floor,
    String order,
    List<Parameter> parameters,
    boolean shared,
    String user,
    @Nullable Long owner,
    Instant changedAt) {

  /** As many as a site has. */
  public static final int MOST = 500;

  /** As many as one has. */
  public static final int MOST_PARAMETERS = 20;

  /**
   * @param field what it fills, named from the top with dots between, as {@code stops.1}
   */
  public record Parameter(String name, String field) {}

  public TaskTemplate {
    parameters = List.copyOf(parameters);
  }
}
