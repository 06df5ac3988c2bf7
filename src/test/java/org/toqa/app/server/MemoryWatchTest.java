package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.lang.management.MemoryUsage;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

class MemoryWatchTest {
  private static final long MEGABYTE = 1024 * 1024;

  @Test
  void whatStaysInUseIsTold() {
    assertEquals(
        Optional.of(Phrase.MEMORY_EXHAUSTED.with(98L, 100L)), found(98 * MEGABYTE, 100 * MEGABYTE));
  }

  @Test
  void whatIsLeftIsEnough() {
    assertEquals(Optional.empty(), found(90 * MEGABYTE, 100 * MEGABYTE));
    assertEquals(Optional.empty(), found(98 * MEGABYTE, -1), "a pool without a limit");
    assertEquals(Optional.empty(), new MemoryWatch(() -> null).check(), "no collection yet");
  }

  @Test
  void thisProcessHasAPoolToWatch() {
    assertEquals(Optional.empty(), MemoryWatch.ofThisProcess().check());
  }

  private static Optional<Sentence> found(long used, long max) {
    return new MemoryWatch(() -> new MemoryUsage(0, used, used, max)).check();
  }
}
