package org.toqa.app.command;

import picocli.CommandLine.Model.CommandSpec;
import tools.jackson.databind.json.JsonMapper;

/** What a command prints: results to standard output, sentences to standard error. */
public record CommandOutput(CommandSpec spec) {

  /** Prints a result as JSON, on one line. */
  public void printJson(Object result) {
    print(JsonMapper.shared().writeValueAsString(result));
  }

  /** Prints a result as it is. */
  public void print(String result) {
    spec.commandLine().getOut().println(result);
  }

  /** Prints what went wrong, or what is worth knowing beside the result. */
  public void printError(String sentence) {
    spec.commandLine().getErr().println("toqa: " + sentence);
  }
}
