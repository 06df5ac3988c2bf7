package org.toqa.mission;

import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/**
 * Where a task starts or ends.
 *
 * @param position metres, map frame
 * @param station the station's name, where it was given by name
 */
public record TaskPlace(Vec2 position, @Nullable String station) {}
