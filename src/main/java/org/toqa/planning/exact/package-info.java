/**
 * The length of the shortest path of a disc, exactly: what {@code planning.smooth} is measured and
 * tested by. It shares no code with what it judges, and nothing that drives uses it.
 */
@NullMarked
package org.toqa.planning.exact;

import org.jspecify.annotations.NullMarked;
