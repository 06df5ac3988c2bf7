package org.toqa.fleet;

import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.wording.Sentence;

/**
 * What is wrong with a drawing of a floor, or follows from it.
 *
 * @param isBlocking whether it cannot be published so; else it can, by who has seen this
 * @param text what, where, and what to do
 * @param where metres, map frame; null: at no place
 */
public record MapProblem(boolean isBlocking, Sentence text, @Nullable Vec2 where) {}
