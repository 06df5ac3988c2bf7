package org.toqa.link.channel;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class BackoffTest {

  @Test
  void waitsDoubleUpToFiveSecondsAndStartAnew() {
    Backoff backoff = new Backoff();

    assertEquals(
        List.of(250L, 500L, 1_000L, 2_000L, 4_000L, 5_000L, 5_000L),
        Stream.generate(backoff::nextDelay).limit(7).map(Duration::toMillis).toList());
    backoff.reset();
    assertEquals(Duration.ofMillis(250), backoff.nextDelay());
  }
}
