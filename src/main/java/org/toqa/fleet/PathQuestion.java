package org.toqa.fleet;

import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskOrder.Where;

/**
 * How does a robot get from here to there?
 *
 * @param floor null: the only floor, or the first
 */
public record PathQuestion(@Nullable String floor, Where start, Where goal) {}
