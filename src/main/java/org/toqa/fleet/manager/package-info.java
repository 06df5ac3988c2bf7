/** The manager agent: takes and allocates tasks, registers robots, publishes snapshots. */
@NullMarked
package org.toqa.fleet.manager;

import org.jspecify.annotations.NullMarked;
