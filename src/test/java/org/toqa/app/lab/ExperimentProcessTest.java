package org.toqa.app.lab;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.toqa.lab.Experiments;
import org.toqa.lab.drawing.Animation;
import org.toqa.lab.drawing.Drawing;
import org.toqa.lab.experiment.Report;
import org.toqa.lab.experiment.Run;
import org.toqa.lab.record.ExperimentRunner.Outcome;
import org.toqa.lab.record.KeptDrawing;
import org.toqa.lab.record.LabOrder;
import org.toqa.lab.record.LabResult;
import org.toqa.lab.record.ReportJson;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Experiments in real processes. */
@Tag("full")
class ExperimentProcessTest {
  private final ConcurrentLinkedQueue<Double> shares = new ConcurrentLinkedQueue<>();

  private Outcome run(LabOrder order, AtomicBoolean stop) throws InterruptedException {
    return new ExperimentProcess().run(order, (share, step) -> shares.add(share), stop::get);
  }

  @Test
  void aRunGivesWhatTheCommandLineGives() throws Exception {
    LabOrder order = new LabOrder("csm-static", 7, 1, Map.of("lag", 0.2));
    LabResult result =
        assertInstanceOf(Outcome.Done.class, run(order, new AtomicBoolean())).result();

    Run same = new Run(7, 1, order.values(), (share, step) -> {}, () -> false);
    var experiment = Experiments.named("csm-static").orElseThrow();
    Report report = experiment.run(same);
    assertEquals(ReportJson.text(experiment, same, report), result.report());
    assertEquals(
        report.drawings().stream().map(Drawing::svg).toList(),
        result.drawings().stream().map(KeptDrawing::svg).toList());
    assertEquals(report.figures(), ReportJson.read(result.report()).figures());
    assertEquals(report.tables(), ReportJson.read(result.report()).tables());
    assertTrue(shares.contains(0.75), "progress is told: " + shares);

    Animation animation =
        report.drawings().stream()
            .filter(Animation.class::isInstance)
            .map(Animation.class::cast)
            .findFirst()
            .orElseThrow();
    KeptDrawing kept =
        result.drawings().stream()
            .filter(drawing -> drawing.name().equals(animation.name()))
            .findFirst()
            .orElseThrow();
    JsonNode motion = JsonMapper.shared().readTree(String.valueOf(kept.motion()));
    JsonNode track = motion.path("bodies").path(0).path("track");
    assertEquals(animation.bodies().getFirst().track().size(), track.size());
    assertEquals(
        animation.bodies().getFirst().track().getLast().x(),
        track.path(track.size() - 1).path(0).doubleValue(),
        0.0006);
  }

  @Test
  void aRunHasTheLowestPriorityAndOneThatIsStoppedLeavesNoProcess() throws Exception {
    AtomicBoolean stop = new AtomicBoolean();
    LabOrder endless = new LabOrder("virtual-leader-limits", 1, 10_000, Map.of());
    Set<Long> before =
        ProcessHandle.current().children().map(ProcessHandle::pid).collect(Collectors.toSet());
    List<ProcessHandle> begun = new ArrayList<>();
    List<String> priorities = new ArrayList<>();

    Outcome outcome =
        new ExperimentProcess()
            .run(
                endless,
                (share, step) -> {
                  ProcessHandle.current()
                      .children()
                      .filter(child -> !before.contains(child.pid()))
                      .forEach(
                          child -> {
                            begun.add(child);
                            priorities.add(niceness(child.pid()));
                          });
                  stop.set(true);
                },
                stop::get);

    assertInstanceOf(Outcome.Stopped.class, outcome);
    assertEquals(List.of("19"), priorities.stream().distinct().toList());
    assertTrue(begun.stream().noneMatch(ProcessHandle::isAlive));
  }

  /** The 19th value of Linux's proc(5), after a name that has no space. */
  private static String niceness(long pid) {
    try {
      return Files.readString(Path.of("/proc/" + pid + "/stat")).split(" ", -1)[18];
    } catch (IOException e) {
      return e.toString();
    }
  }

  @Test
  void aProcessThatCannotDoItSaysWhy() throws Exception {
    Outcome outcome = run(new LabOrder("no-such", 1, 1, Map.of()), new AtomicBoolean());

    String detail = assertInstanceOf(Outcome.Failed.class, outcome).detail();
    assertTrue(detail.contains("code 2") && detail.contains("is no experiment"), detail);
  }
}
