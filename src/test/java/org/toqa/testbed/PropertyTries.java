package org.toqa.testbed;

import net.jqwik.api.lifecycle.AroundPropertyHook;
import net.jqwik.api.lifecycle.PropagationMode;
import net.jqwik.api.lifecycle.PropertyAttributes;
import net.jqwik.api.lifecycle.PropertyExecutionResult;
import net.jqwik.api.lifecycle.PropertyExecutor;
import net.jqwik.api.lifecycle.PropertyLifecycleContext;

/**
 * Counts what properties try; found by jqwik as a service. With {@code -Dtoqa.seed} all of them
 * begin from that seed; with {@code -Dtoqa.tries=20} they try twenty times as much as they say.
 */
public final class PropertyTries implements AroundPropertyHook {
  private static final String SEED = System.getProperty("toqa.seed", "");
  private static final int TIMES = Integer.getInteger("toqa.tries", 1);

  /** What jqwik does where a property does not say it. */
  private static final int USUAL = 1000;

  @Override
  public PropagationMode propagateTo() {
    return PropagationMode.ALL_DESCENDANTS;
  }

  @Override
  public PropertyExecutionResult aroundProperty(
      PropertyLifecycleContext context, PropertyExecutor property) {
    PropertyAttributes attributes = context.attributes();
    if (!SEED.isEmpty()) {
      attributes.setSeed(SEED);
    }
    if (TIMES != 1) {
      attributes.setTries(TIMES * attributes.tries().orElse(USUAL));
    }
    PropertyExecutionResult result = property.execute();
    Tally.add("properties", 1);
    Tally.add("property tries", result.countTries());
    return result;
  }
}
