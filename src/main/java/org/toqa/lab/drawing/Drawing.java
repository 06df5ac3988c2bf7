package org.toqa.lab.drawing;

/** A picture of a report. */
public sealed interface Drawing permits Chart, Scene, Animation {
  /** Of its file, without the ending: lower-case words with hyphens. */
  String name();

  /** For a person. */
  String title();

  /** The picture as an SVG document. */
  String svg();
}
