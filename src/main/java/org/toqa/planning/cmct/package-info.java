/**
 * The path planner CMCT-PP (Elsonbaty, Rizk, Elksas and Salem, "A Cooperative Multi-Robot Control
 * Using Ad Hoc Wireless Network"), and A* with the same moves to compare it with.
 */
@NullMarked
package org.toqa.planning.cmct;

import org.jspecify.annotations.NullMarked;
