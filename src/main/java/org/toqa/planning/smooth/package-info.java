/**
 * Short smooth paths for a disc in the plane, by sampling and a swarm (CSM-MAMRS, "Hybrid
 * RRT*-PSO"). The data's walk:
 *
 * <ol>
 *   <li>{@link DiscSpace} is made of an occupancy grid and a radius: where the disc's centre may
 *       be, by exact distances.
 *   <li>{@link SmoothPlanner} asks whether start and goal are free. A {@code Lattice} gives a first
 *       path, or {@code Connectivity} tells that there can be none; where a lattice of half cells
 *       is too coarse, {@code LatticeSearch} has finer ones. From then on a tree grows ({@code
 *       RandomTree}, with points of {@code InformedSampler} in a {@code PointTree}).
 *   <li>Paths of the tree are pulled taut ({@code PathShortener}), and the way points of the best
 *       one are moved by a {@code ParticleSwarm}. Its length bounds where the tree samples next.
 *   <li>The answer, a {@link WayPath} or a reason, goes to {@code planning.smooth.curve}, which
 *       makes a curve of it that a robot can drive.
 * </ol>
 *
 * <p>Inside, points are in cells from the grid's lower left corner, x to the east and y to the
 * north; at the borders of the package they are metres in the map frame.
 */
@NullMarked
package org.toqa.planning.smooth;

import org.jspecify.annotations.NullMarked;
