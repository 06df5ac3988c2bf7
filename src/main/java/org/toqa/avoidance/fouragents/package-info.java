/**
 * Four agents in one robot, of which one drives at a time: perception, navigation, and the
 * avoidance of known static and of unknown moving obstacles (Ayedi, Boujelben, Rekik 2018). Values
 * in, values out; time is handed in.
 */
@NullMarked
package org.toqa.avoidance.fouragents;

import org.jspecify.annotations.NullMarked;
