package org.toqa.app;

import static java.util.Objects.requireNonNull;

import java.io.PrintWriter;
import java.util.Set;
import org.toqa.app.bench.AllocationBench;
import org.toqa.app.bench.BenchCommand;
import org.toqa.app.bench.FormationBench;
import org.toqa.app.plan.PlanCommand;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;
import picocli.CommandLine.UnmatchedArgumentException;

/** The command line of the server. */
@Command(
    name = "toqa",
    description = "A fleet server for cooperating mobile robots.",
    subcommands = {DemoCommand.class, ServerCommand.class, PlanCommand.class, BenchCommand.class})
public final class Main implements Runnable {

  /** A run that failed. */
  static final int FAILED = 1;

  /** A wrong argument or configuration. */
  static final int WRONG = 2;

  @Option(
      names = {"-h", "--help"},
      usageHelp = true,
      scope = ScopeType.INHERIT,
      description = "Shows this.")
  @SuppressWarnings("unused") // picocli asks the option, nobody the field
  private boolean help;

  @Spec private CommandSpec spec = CommandSpec.create();

  private Main() {}

  public static void main(String[] args) {
    System.exit(commandLine().execute(args));
  }

  static CommandLine commandLine() {
    CommandLine line = new CommandLine(new Main());
    // The other benches know nothing of a server; some need all of it, two its map.
    requireNonNull(line.getSubcommands().get("bench"))
        .addSubcommand(new FleetBench())
        .addSubcommand(new TaskBench())
        .addSubcommand(new WebBench())
        .addSubcommand(new DaemonBench())
        .addSubcommand(new AllocationBench(Webapp::shippedMap))
        .addSubcommand(new FormationBench(Webapp::shippedMap));
    return line.setParameterExceptionHandler((e, args) -> complain(e))
        .setExecutionExceptionHandler((e, command, result) -> fail(e, command));
  }

  @Override
  public void run() {
    throw new ParameterException(spec.commandLine(), "A command is missing");
  }

  private static int complain(ParameterException e) {
    CommandLine command = e.getCommandLine();
    String sentence =
        e instanceof UnmatchedArgumentException unmatched
            ? notKnown(unmatched.getUnmatched().getFirst(), command)
            : String.valueOf(e.getMessage()).lines().findFirst().orElse("");
    line(
        command.getErr(),
        sentence
            + " ("
            + command.getCommandSpec().qualifiedName()
            + " --help lists what there is)");
    return WRONG;
  }

  private static String notKnown(String written, CommandLine command) {
    CommandSpec spec = command.getCommandSpec();
    boolean isOption = written.startsWith("-");
    Set<String> known = isOption ? spec.optionsMap().keySet() : spec.subcommands().keySet();
    String sentence = "\"" + written + "\" is not known";
    return known.isEmpty()
        ? sentence
        : sentence + "; the nearest is " + Spelling.nearest(written, known).word();
  }

  private static int fail(Exception e, CommandLine command) {
    line(command.getErr(), String.valueOf(e.getMessage()));
    return e instanceof ConfigurationException ? WRONG : FAILED;
  }

  private static void line(PrintWriter err, String sentence) {
    err.println("toqa: " + sentence);
    err.flush();
  }
}
