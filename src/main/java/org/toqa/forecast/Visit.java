package org.toqa.forecast;

import org.toqa.geometry.Vec2;

/**
 * A place to which a task still has to come.
 *
 * @param place metres, map frame
 * @param waitSeconds for which its robots wait there after they have come; infinite: until a person
 *     says that they may go on
 */
public record Visit(Vec2 place, double waitSeconds) {}
