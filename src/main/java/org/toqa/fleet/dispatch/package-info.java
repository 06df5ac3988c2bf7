/**
 * A floor's dispatch: its agent takes and allocates the floor's tasks, registers its robots and
 * publishes its snapshots.
 */
@NullMarked
package org.toqa.fleet.dispatch;

import org.jspecify.annotations.NullMarked;
