package org.toqa.accounts;

import org.jspecify.annotations.Nullable;

/**
 * Who gets what a deleted user leaves behind. His open tasks are not in it: the fleet has them.
 *
 * @param schedules who gets his schedules; null: they are removed
 * @param tokens who gets his API tokens, which may then what he may; null: they end
 */
public record Handover(@Nullable Account schedules, @Nullable Account tokens) {
  /** All of it is removed. */
  public static final Handover NONE = new Handover(null, null);
}
