package org.toqa.app.lab;

import java.io.BufferedReader;
import java.io.File;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.lab.experiment.Run.ProgressListener;
import org.toqa.lab.record.ExperimentRunner;
import org.toqa.lab.record.KeptDrawing;
import org.toqa.lab.record.LabOrder;
import org.toqa.lab.record.LabResult;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Lets {@code toqa lab} do experiments in a process of its own, at the lowest priority, on one
 * processor and with a limit of memory, so that whatever one does the server goes on. The process
 * ends with this one, however this one ends; its end of the pipes is {@link ServerPipe}.
 */
public final class ExperimentProcess implements ExperimentRunner {
  /** Megabytes of a run's heap. */
  public static final int HEAP = 512;

  /** Bytes that a run may give. */
  public static final int MOST_BYTES = 8 << 20;

  /** A run that takes longer is ended. */
  public static final Duration LONGEST = Duration.ofHours(2);

  private static final String MAIN = "org.toqa.app.Main";
  private static final int LOOK_MILLIS = 100;

  /** For a process that was told to end. */
  private static final Duration END_LIMIT = Duration.ofSeconds(10);

  /** Characters of standard error that are kept for who asks why. */
  private static final int LAST_WORDS = 600;

  /** What a process has said until it ended. */
  private record Said(List<KeptDrawing> drawings, @Nullable String report) {}

  @Override
  public Outcome run(LabOrder order, ProgressListener listener, BooleanSupplier isStopped)
      throws InterruptedException {
    Process process;
    try {
      process = new ProcessBuilder(command(order)).start();
    } catch (IOException e) {
      return new Outcome.Failed("No process could be started for it: " + e.getMessage());
    }
    try {
      CompletableFuture<Said> said = inBackground(() -> read(process, listener));
      CompletableFuture<String> errors = inBackground(() -> lastWords(process.getErrorStream()));
      boolean isLate = !awaitEnd(process, isStopped);
      return outcome(process.exitValue(), said, errors, isStopped.getAsBoolean(), isLate);
    } finally {
      process.destroyForcibly();
    }
  }

  private interface Reading<T> {
    T read() throws IOException;
  }

  private static <T> CompletableFuture<T> inBackground(Reading<T> reading) {
    return CompletableFuture.supplyAsync(
        () -> {
          try {
            return reading.read();
          } catch (IOException e) {
            throw new UncheckedIOException(e);
          }
        },
        task -> Thread.ofVirtual().name("experiment").start(task));
  }

  private static List<String> command(LabOrder order) {
    List<String> command = new ArrayList<>();
    Stream.of("/usr/bin/nice", "/bin/nice")
        .filter(nice -> Files.isExecutable(Path.of(nice)))
        .findFirst()
        .ifPresent(nice -> command.addAll(List.of(nice, "-n", "19")));
    command.addAll(
        List.of(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-Xmx" + HEAP + "m",
            "-XX:+UseSerialGC",
            "-XX:ActiveProcessorCount=1",
            "-XX:+ExitOnOutOfMemoryError",
            "-cp",
            classPath(),
            MAIN,
            "lab",
            order.experiment(),
            ServerPipe.OPTION,
            "--seed",
            String.valueOf(order.seed()),
            "--runs",
            String.valueOf(order.runs())));
    order.values().forEach((name, value) -> command.addAll(List.of("--set", name + "=" + value)));
    return command;
  }

  /** Of this program: an unpacked web application, whoever serves it, or folders and libraries. */
  private static String classPath() {
    try {
      URI here =
          ExperimentProcess.class.getProtectionDomain().getCodeSource().getLocation().toURI();
      Path classes = Path.of(here);
      Path folder = classes.getParent();
      return classes.endsWith("WEB-INF/classes") && folder != null
          ? Stream.of("classes", "lib/*", "server/*")
              .map(part -> folder + File.separator + part)
              .reduce((a, b) -> a + File.pathSeparator + b)
              .orElseThrow()
          : System.getProperty("java.class.path");
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }

  /**
   * Returns when the process has ended.
   *
   * @return whether it was in time
   */
  private static boolean awaitEnd(Process process, BooleanSupplier isStopped)
      throws InterruptedException {
    long begun = System.nanoTime();
    while (!process.waitFor(LOOK_MILLIS, TimeUnit.MILLISECONDS)) {
      boolean isLate = System.nanoTime() - begun > LONGEST.toNanos();
      if (isLate || isStopped.getAsBoolean()) {
        end(process);
        return !isLate;
      }
    }
    return true;
  }

  private static void end(Process process) throws InterruptedException {
    try {
      process.getOutputStream().close();
    } catch (IOException e) {
      // it is gone already
    }
    if (!process.waitFor(END_LIMIT.toMillis(), TimeUnit.MILLISECONDS)) {
      process.destroyForcibly();
      process.waitFor();
    }
  }

  private static Outcome outcome(
      int code,
      CompletableFuture<Said> said,
      CompletableFuture<String> errors,
      boolean isStopped,
      boolean isLate) {
    if (isLate) {
      return new Outcome.Failed(
          "It took longer than %d hours. Take fewer runs.".formatted(LONGEST.toHours()));
    }
    try {
      Said all = said.join();
      String report = all.report();
      if (code == 0 && report != null) {
        return new Outcome.Done(new LabResult(report, all.drawings()));
      }
    } catch (CompletionException e) {
      if (!isStopped) {
        return new Outcome.Failed(reason(e));
      }
    }
    if (isStopped) {
      return new Outcome.Stopped();
    }
    String words = errors.join();
    return new Outcome.Failed(
        words.contains("OutOfMemoryError")
            ? "It needs more than the %d MB that a run gets. Take fewer runs.".formatted(HEAP)
            : "Its process ended with code %d. %s".formatted(code, words).strip());
  }

  private static String reason(CompletionException e) {
    return e.getCause() instanceof UncheckedIOException failure && failure.getCause() != null
        ? String.valueOf(failure.getCause().getMessage())
        : String.valueOf(e.getMessage());
  }

  private static Said read(Process process, ProgressListener listener) throws IOException {
    List<KeptDrawing> drawings = new ArrayList<>();
    String report = null;
    try (BufferedReader lines =
        new BufferedReader(
            new InputStreamReader(
                new LimitedStream(process.getInputStream()), StandardCharsets.UTF_8))) {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        if (!line.startsWith("{")) {
          continue; // a library says something
        }
        JsonNode said = JsonMapper.shared().readTree(line);
        if (said.has("share")) {
          listener.progress(said.path("share").doubleValue(), said.path("step").stringValue(""));
        } else if (said.has("svg")) {
          drawings.add(
              new KeptDrawing(
                  said.path("name").stringValue(""),
                  said.path("title").stringValue(""),
                  said.path("svg").stringValue(""),
                  said.path("motion").stringValue(null)));
        } else {
          report = said.path("report").stringValue(null);
        }
      }
    } catch (JacksonException e) {
      process.destroyForcibly(); // it was killed amid a line, or else it is to be
      return new Said(drawings, null);
    } catch (IOException e) {
      process.destroyForcibly(); // or it would wait for ever until somebody reads on
      throw e;
    }
    return new Said(drawings, report);
  }

  private static String lastWords(InputStream errors) throws IOException {
    StringBuilder words = new StringBuilder();
    try (InputStreamReader reader = new InputStreamReader(errors, StandardCharsets.UTF_8)) {
      char[] some = new char[LAST_WORDS];
      for (int read = reader.read(some); read >= 0; read = reader.read(some)) {
        words.append(some, 0, read);
        words.delete(0, Math.max(0, words.length() - LAST_WORDS));
      }
    }
    return words.toString().strip();
  }

  /** Ends with a fault when more has come than is kept. */
  private static final class LimitedStream extends FilterInputStream {
    private int left = MOST_BYTES;

    LimitedStream(InputStream from) {
      super(from);
    }

    @Override
    public int read() throws IOException {
      int read = super.read();
      count(read < 0 ? 0 : 1);
      return read;
    }

    @Override
    public int read(byte[] into, int offset, int length) throws IOException {
      int read = super.read(into, offset, length);
      count(Math.max(0, read));
      return read;
    }

    private void count(int bytes) throws IOException {
      left -= bytes;
      if (left < 0) {
        throw new IOException(
            "It gave more than the %d MB that are kept of a run. Take fewer runs."
                .formatted(MOST_BYTES >> 20));
      }
    }
  }
}
