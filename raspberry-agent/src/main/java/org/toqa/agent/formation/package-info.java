/** Carrying together: what a leader broadcasts, how a follower keeps its place. */
@NullMarked
package org.toqa.agent.formation;

import org.jspecify.annotations.NullMarked;
