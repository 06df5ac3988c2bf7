package org.toqa.app.lab;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.toqa.app.command.CommandOutput;
import org.toqa.lab.drawing.Animation;
import org.toqa.lab.drawing.Drawing;
import org.toqa.lab.experiment.Experiment;
import org.toqa.lab.experiment.Report;
import org.toqa.lab.experiment.Run;
import org.toqa.lab.experiment.RunStoppedException;
import org.toqa.lab.record.AnimationJson;
import org.toqa.lab.record.ReportJson;
import picocli.CommandLine.ExitCode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/**
 * The child's end of the pipes between a server and the process in which it lets an experiment run;
 * the other end is {@link ExperimentProcess}.
 *
 * <p>Standard output has a JSON object a line: {@code {"share","step"}} for progress, then {@code
 * {"name","title","svg","motion"}} for each drawing, and last {@code {"report"}}. When standard
 * input ends, because the server wants it so or is gone, the run ends too.
 */
final class ServerPipe {
  static final String OPTION = "--for-server";

  /** Of a run that was ended by its server. */
  static final int STOPPED = 130;

  /** An experiment that does not end by itself is ended then. */
  private static final int END_LIMIT_SECONDS = 5;

  private final CommandOutput output;
  private final AtomicBoolean isStopped = new AtomicBoolean();

  private ServerPipe(CommandOutput output) {
    this.output = output;
  }

  static ServerPipe open(CommandOutput output) {
    ServerPipe pipe = new ServerPipe(output);
    Thread.ofPlatform().daemon().name("server").start(pipe::awaitEnd);
    offerToBeKilledFirst();
    return pipe;
  }

  /** Where memory is short, Linux takes this process before any other one. */
  private static void offerToBeKilledFirst() {
    Path score = Path.of("/proc/self/oom_score_adj");
    if (Files.isWritable(score)) {
      try {
        Files.writeString(score, "1000");
      } catch (IOException e) {
        // then it is taken in its turn
      }
    }
  }

  private void awaitEnd() {
    try {
      while (System.in.read() >= 0) {
        // the server sends nothing
      }
    } catch (IOException e) {
      // it has ended all the same
    }
    isStopped.set(true);
    try {
      TimeUnit.SECONDS.sleep(END_LIMIT_SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    Runtime.getRuntime().halt(STOPPED);
  }

  int run(Experiment experiment, long seed, int runs, Map<String, Double> values) {
    Run run = new Run(seed, runs, values, this::tellProgress, isStopped::get);
    try {
      Report report = experiment.run(run);
      report.drawings().forEach(this::tell);
      ObjectNode last = JsonMapper.shared().createObjectNode();
      last.put("report", ReportJson.text(experiment, run, report));
      print(last);
      return ExitCode.OK;
    } catch (RunStoppedException e) {
      return STOPPED;
    }
  }

  private void tellProgress(double share, String step) {
    ObjectNode line = JsonMapper.shared().createObjectNode();
    line.put("share", share);
    line.put("step", step);
    print(line);
  }

  private void tell(Drawing drawing) {
    ObjectNode line = JsonMapper.shared().createObjectNode();
    line.put("name", drawing.name());
    line.put("title", drawing.title());
    line.put("svg", drawing.svg());
    if (drawing instanceof Animation animation) {
      line.put("motion", AnimationJson.text(animation));
    }
    print(line);
  }

  private void print(ObjectNode line) {
    output.print(JsonMapper.shared().writeValueAsString(line));
  }
}
