package org.toqa.fleet;

import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.toqa.wording.Sentence;

/**
 * When a task will be picked up and delivered, as it looks now, by the clock by which people live.
 *
 * @param pickUp when its load will be on board; null: it is, there is none, or that cannot be said
 * @param delivery when it will be delivered, or its drive will end; null: that cannot be said
 * @param unknown a sentence why something cannot be said; null: nothing is missing
 */
public record ExpectedTimes(
    @Nullable Instant pickUp, @Nullable Instant delivery, @Nullable Sentence unknown) {}
