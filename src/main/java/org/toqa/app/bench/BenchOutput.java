package org.toqa.app.bench;

import org.toqa.app.command.CommandOutput;
import picocli.CommandLine.Model.CommandSpec;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** What a bench prints: its report, and what it leaves out. */
record BenchOutput(CommandSpec spec) {

  /**
   * Prints the report as JSON, on one line, with {@link LeftOut} as {@code leavesOut}.
   *
   * @param report is written as an object
   */
  void printReport(Object report) {
    ObjectNode json = JsonMapper.shared().valueToTree(report);
    json.putPOJO("leavesOut", LeftOut.of(spec.name()).sentences());
    new CommandOutput(spec).printJson(json);
  }
}
