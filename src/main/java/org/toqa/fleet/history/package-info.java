/** What is kept of past work: events, tracks, utilisation; and the ports it is read by. */
@NullMarked
package org.toqa.fleet.history;

import org.jspecify.annotations.NullMarked;
