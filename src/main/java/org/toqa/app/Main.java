package org.toqa.app;

import java.io.PrintWriter;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.toqa.app.bench.BenchCommand;
import org.toqa.app.command.NumberConverters;
import org.toqa.app.config.ConfigurationException;
import org.toqa.app.demo.DemoCommand;
import org.toqa.app.gateway.GatewayCommand;
import org.toqa.app.lab.LabCommand;
import org.toqa.app.plan.PlanCommand;
import org.toqa.app.robot.HttpRobotCommand;
import org.toqa.app.server.ServerCommand;
import org.toqa.grid.MapFormatException;
import org.toqa.yaml.Spelling;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;
import picocli.CommandLine.UnmatchedArgumentException;

/** The command line of the server. */
@Command(name = "toqa", description = "A fleet server for cooperating mobile robots.")
public final class Main implements Runnable {
  /** As the help lists them. */
  private static final List<Class<?>> COMMANDS =
      List.of(
          DemoCommand.class,
          ServerCommand.class,
          GatewayCommand.class,
          HttpRobotCommand.class,
          PlanCommand.class,
          BenchCommand.class,
          LabCommand.class);

  @Option(
      names = {"-h", "--help"},
      usageHelp = true,
      scope = ScopeType.INHERIT,
      description = "Show this help and exit.")
  @SuppressWarnings("unused") // picocli asks the option, nobody the field
  private boolean help;

  @Spec private CommandSpec spec = CommandSpec.create();

  private Main() {}

  public static void main(String[] args) {
    System.exit(commandLineFor(args).execute(args));
  }

  /** All that there is. */
  static CommandLine commandLine() {
    return commandLine(COMMANDS);
  }

  /** With the command alone that the arguments begin with, else with all: each delays the start. */
  static CommandLine commandLineFor(String... args) {
    return commandLine(
        COMMANDS.stream()
            .filter(command -> args.length > 0 && nameOf(command).equals(args[0]))
            .findFirst()
            .<List<Class<?>>>map(List::of)
            .orElse(COMMANDS));
  }

  private static String nameOf(Class<?> command) {
    return command.getAnnotation(Command.class).name();
  }

  private static CommandLine commandLine(List<Class<?>> commands) {
    CommandLine all = new CommandLine(new Main());
    commands.forEach(all::addSubcommand);
    return NumberConverters.register(all)
        .setParameterExceptionHandler((e, args) -> reportWrongArgument(e))
        .setExecutionExceptionHandler((e, command, result) -> reportFailure(e, command));
  }

  @Override
  public void run() {
    throw new ParameterException(spec.commandLine(), "A command is missing");
  }

  private static int reportWrongArgument(ParameterException e) {
    CommandLine command = e.getCommandLine();
    List<String> unknown =
        e instanceof UnmatchedArgumentException unmatched
            ? unmatched.getUnmatched()
            : command.getUnmatchedArguments(); // which says more than that others are missing
    String sentence =
        !unknown.isEmpty()
            ? unknownWordMessage(unknown.getFirst(), command)
            : String.valueOf(e.getMessage())
                .lines()
                .findFirst()
                .orElse("")
                .replace("option option", "option"); // as picocli says of a pair without "="
    printError(
        command.getErr(),
        sentence
            + " ("
            + command.getCommandSpec().qualifiedName()
            + " --help lists what there is)");
    return ExitCode.USAGE;
  }

  private static String unknownWordMessage(String written, CommandLine command) {
    CommandSpec spec = command.getCommandSpec();
    boolean isOption = written.startsWith("-");
    Set<String> known = isOption ? spec.optionsMap().keySet() : spec.subcommands().keySet();
    String sentence = "\"" + written + "\" is not known";
    return known.isEmpty()
        ? sentence
        : Spelling.near(written, new TreeSet<>(known))
            .map(near -> sentence + "; the nearest is " + near)
            .orElse(sentence);
  }

  private static int reportFailure(Exception e, CommandLine command) {
    printError(
        command.getErr(),
        e instanceof FileSystemException failed
            ? fileMessage(failed)
            : String.valueOf(e.getMessage()));
    return e instanceof ConfigurationException || e instanceof MapFormatException
        ? ExitCode.USAGE
        : ExitCode.SOFTWARE;
  }

  /** Of an error of a file system, whose own message is often no more than the file's name. */
  private static String fileMessage(FileSystemException e) {
    String reason =
        switch (e) {
          case AccessDeniedException _ -> "this user may not read or write it";
          case NoSuchFileException _ -> "it is not there, and cannot be made";
          case FileAlreadyExistsException _ -> "it is a file, not a folder";
          default -> e.getReason() == null ? "it cannot be read or written" : e.getReason();
        };
    return e.getFile() + ": " + reason + "; choose another one, or mend that.";
  }

  private static void printError(PrintWriter err, String sentence) {
    err.println("toqa: " + sentence);
    err.flush();
  }
}
