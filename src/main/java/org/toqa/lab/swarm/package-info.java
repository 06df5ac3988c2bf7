/** The experiments with the swarm behind a virtual leader. */
@NullMarked
package org.toqa.lab.swarm;

import org.jspecify.annotations.NullMarked;
