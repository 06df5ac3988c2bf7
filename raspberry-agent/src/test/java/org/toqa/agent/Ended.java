package org.toqa.agent;

import java.io.PrintWriter;
import java.io.StringWriter;
import picocli.CommandLine;

/**
 * A command line of the daemon that has ended.
 *
 * @param errors what it wrote to standard error
 */
record Ended(int exitCode, String errors) {

  static Ended of(String... arguments) {
    StringWriter errors = new StringWriter();
    CommandLine line = new CommandLine(new Main());
    line.setErr(new PrintWriter(errors, true));
    line.setOut(new PrintWriter(new StringWriter(), true));
    return new Ended(line.execute(arguments), errors.toString());
  }
}
