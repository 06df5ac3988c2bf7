package org.toqa.network;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * Whether a device answers.
 *
 * @param heardAt when it did last, since this server was started; null: never
 */
record Contact(boolean reachable, @Nullable Instant heardAt) {}
