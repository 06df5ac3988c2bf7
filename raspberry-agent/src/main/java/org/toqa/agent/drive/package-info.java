/** Driving: the reference trajectory, the runner of its segments, obstacles before it. */
@NullMarked
package org.toqa.agent.drive;

import org.jspecify.annotations.NullMarked;
