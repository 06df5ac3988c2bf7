package org.toqa.app.plan;

import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Trajectory;
import org.toqa.planning.Path;

/**
 * A path on a map, and the trajectory by which a robot drives it.
 *
 * @param floor the map as it was read
 * @param inflated its grid with the margin round the obstacles, on which the path was planned
 * @param trajectory metres and radians, map frame, from the middle of the first cell to the middle
 *     of the last one
 */
record PlannedDrive(FloorMap floor, OccupancyGrid inflated, Path path, Trajectory trajectory) {}
