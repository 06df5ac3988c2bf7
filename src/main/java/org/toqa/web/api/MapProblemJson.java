package org.toqa.web.api;

import org.jspecify.annotations.Nullable;
import org.toqa.fleet.MapProblem;
import org.toqa.geometry.Vec2;
import org.toqa.wording.Sentence;

/** What is wrong with a drawing, on the wire; the fields are those of {@link MapProblem}. */
record MapProblemJson(boolean blocking, Sentence text, @Nullable Vec2 where) {
  static MapProblemJson of(MapProblem problem) {
    return new MapProblemJson(problem.isBlocking(), problem.text(), problem.where());
  }
}
