package org.toqa.testbed;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;

/** For tests with a browser: nobody changes network interfaces meanwhile. */
public final class SteadyNetwork implements BeforeEachCallback, AfterEachCallback {
  private @Nullable NetworkLock lock;

  @Override
  public void beforeEach(ExtensionContext context) throws IOException {
    lock = NetworkLock.toBrowse();
  }

  @Override
  public void afterEach(ExtensionContext context) throws IOException {
    requireNonNull(lock).close();
  }
}
