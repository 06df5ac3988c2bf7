package org.toqa.fleet;

import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.toqa.wording.Sentence;

/**
 * What is so after a {@link ManualOrder}.
 *
 * @param lease to be shown with the next one
 * @param driver who drives the robot
 * @param isDriving whether it has something to drive now
 * @param refusal why it does not go on as it was told; null: it does, or is not ready yet
 */
public record ManualAnswer(
    UUID lease, String driver, boolean isDriving, @Nullable Sentence refusal) {}
