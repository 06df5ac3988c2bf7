package org.toqa.testbed;

import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.engine.TestExecutionResult.Status;
import org.junit.platform.engine.TestSource;
import org.junit.platform.engine.support.descriptor.ClassSource;
import org.junit.platform.engine.support.descriptor.MethodSource;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.TestPlan;

/** Counts the tests of all engines; found by JUnit as a service. */
public final class TestTally implements TestExecutionListener {
  private final Map<Kind, Integer> counts = new EnumMap<>(Kind.class);

  private enum Kind {
    UNIT_TESTS,
    BROWSER_TESTS,
    PACKAGED_TESTS;

    static Kind of(String className) {
      if (className.endsWith("InBrowserTest")) {
        return BROWSER_TESTS;
      }
      return className.endsWith("IT") ? PACKAGED_TESTS : UNIT_TESTS;
    }
  }

  @Override
  public synchronized void executionSkipped(TestIdentifier test, String reason) {
    leaveOut(test, reason);
  }

  @Override
  public synchronized void executionFinished(TestIdentifier test, TestExecutionResult result) {
    if (result.getStatus() == Status.ABORTED) {
      leaveOut(test, result.getThrowable().map(Throwable::getMessage).orElse("no reason"));
    } else if (test.isTest()) {
      counts.merge(Kind.of(className(test)), 1, Integer::sum);
    }
  }

  @Override
  public synchronized void testPlanExecutionFinished(TestPlan plan) {
    counts.forEach(
        (kind, count) -> Tally.add(kind.name().toLowerCase(Locale.ROOT).replace('_', ' '), count));
    counts.clear();
  }

  private static void leaveOut(TestIdentifier test, String reason) {
    Tally.leftOut(className(test) + " " + test.getDisplayName() + ": " + reason);
  }

  private static String className(TestIdentifier test) {
    TestSource source = test.getSource().orElse(null);
    return switch (source) {
      case MethodSource method -> method.getClassName();
      case ClassSource ofClass -> ofClass.getClassName();
      case null, default -> test.getUniqueId();
    };
  }
}
