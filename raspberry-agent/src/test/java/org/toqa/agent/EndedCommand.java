package org.toqa.agent;

import java.io.PrintWriter;
import java.io.StringWriter;
import picocli.CommandLine;

/**
 * A command line of the daemon that has ended.
 *
 * @param errors what it wrote to standard error
 */
public record EndedCommand(int exitCode, String errors) {

  public static EndedCommand of(String... arguments) {
    StringWriter errors = new StringWriter();
    CommandLine line = new CommandLine(new Main());
    line.setErr(new PrintWriter(errors, true));
    line.setOut(new PrintWriter(new StringWriter(), true));
    return new EndedCommand(line.execute(arguments), errors.toString());
  }
}
