package org.toqa.traffic;

import org.toqa.grid.Cell;
import org.toqa.planning.Heading;

/**
 * Where a robot is and which direction it faces.
 *
 * @param heading one of the four straight ones; without meaning in {@link MotionModel#CLASSIC}
 */
public record GridPose(Cell cell, Heading heading) {}
