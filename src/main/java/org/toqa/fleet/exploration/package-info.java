/**
 * Explorations of floors: what a simulated swarm saw of unknown ground becomes the draft of a
 * floor's map ({@link org.toqa.exploration}). The fleet itself takes no part in it.
 */
@NullMarked
package org.toqa.fleet.exploration;

import org.jspecify.annotations.NullMarked;
