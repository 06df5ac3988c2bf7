package org.toqa.lab.record;

import org.jspecify.annotations.Nullable;

/**
 * A drawing of a run that is kept.
 *
 * @param name that no other one of the run has
 * @param title for a person, in English
 * @param svg the document
 * @param motion how bodies move over it, by {@link AnimationJson}; null: nothing does
 */
public record KeptDrawing(String name, String title, String svg, @Nullable String motion) {
  /** What a list of drawings says of one. */
  public record Entry(String name, String title, boolean moving) {}
}
