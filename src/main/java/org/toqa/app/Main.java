package org.toqa.app;

import java.io.PrintWriter;
import java.util.List;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.UnmatchedArgumentException;

/** The command line of the server. */
@Command(
    name = "toqa",
    description = "A fleet server for cooperating mobile robots.",
    mixinStandardHelpOptions = true,
    versionProvider = Main.Version.class,
    subcommands = {DemoCommand.class, ServerCommand.class})
public final class Main implements Runnable {

  /** A run that failed. */
  static final int FAILED = 1;

  /** A wrong argument or configuration. */
  static final int WRONG = 2;

  @Spec private CommandSpec spec = CommandSpec.create();

  private Main() {}

  public static void main(String[] args) {
    System.exit(commandLine().execute(args));
  }

  static CommandLine commandLine() {
    return new CommandLine(new Main())
        .setParameterExceptionHandler((e, args) -> complain(e))
        .setExecutionExceptionHandler((e, command, result) -> fail(e, command));
  }

  @Override
  public void run() {
    throw new ParameterException(spec.commandLine(), "A command is missing");
  }

  private static int complain(ParameterException e) {
    CommandLine command = e.getCommandLine();
    String sentence = String.valueOf(e.getMessage()).lines().findFirst().orElse("");
    List<String> meant =
        e instanceof UnmatchedArgumentException unmatched ? unmatched.getSuggestions() : List.of();
    line(
        command.getErr(),
        sentence
            + (meant.isEmpty() ? "" : "; do you mean " + meant.getFirst() + "?")
            + " ("
            + command.getCommandSpec().qualifiedName()
            + " --help lists what there is)");
    return WRONG;
  }

  private static int fail(Exception e, CommandLine command) {
    line(command.getErr(), String.valueOf(e.getMessage()));
    return e instanceof ConfigurationException ? WRONG : FAILED;
  }

  private static void line(PrintWriter err, String sentence) {
    err.println("toqa: " + sentence);
    err.flush();
  }

  static final class Version implements CommandLine.IVersionProvider {
    @Override
    public String[] getVersion() {
      return new String[] {"toqa"};
    }
  }
}
