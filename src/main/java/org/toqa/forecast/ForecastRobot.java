package org.toqa.forecast;

import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/**
 * A robot as a forecast sees it.
 *
 * @param place where it is when it can be given a task, metres, map frame
 * @param freeIn seconds until it can be, if it has none: it charges, say; infinite: nobody knows
 * @param diameter metres
 * @param speed metres a second, straight on
 * @param turnRate radians a second, on the spot
 * @param maxLoad kilograms
 * @param battery 0 to 1, then; null: not known
 */
public record ForecastRobot(
    String name,
    Vec2 place,
    double freeIn,
    double diameter,
    double speed,
    double turnRate,
    double maxLoad,
    @Nullable Double battery) {}
