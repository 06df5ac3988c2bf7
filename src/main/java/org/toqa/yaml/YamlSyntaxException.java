package org.toqa.yaml;

import java.util.OptionalInt;

/** A text is not YAML, or more than is taken. */
public final class YamlSyntaxException extends Exception {
  private static final long serialVersionUID = 1;

  /** From 1; 0: nobody knows. */
  private final int line;

  private final String problem;

  YamlSyntaxException(int line, String problem, Throwable cause) {
    super(problem, cause);
    this.line = line;
    this.problem = problem;
  }

  /** Counted from 1; empty where the problem has no place. */
  public OptionalInt line() {
    return line > 0 ? OptionalInt.of(line) : OptionalInt.empty();
  }

  /** A clause in English. */
  public String problem() {
    return problem;
  }
}
