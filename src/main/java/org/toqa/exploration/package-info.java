/**
 * A swarm, or one robot with a lidar, drives to a target over ground that it has no map of, and
 * what it sees on the way becomes a map. Values and one drive that is stepped; time and chance are
 * handed in.
 */
@NullMarked
package org.toqa.exploration;

import org.jspecify.annotations.NullMarked;
