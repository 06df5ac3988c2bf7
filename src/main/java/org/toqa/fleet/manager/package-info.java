/**
 * The directory of floors: which there are and how they change, and what holds for all of them.
 * What concerns one floor is handed to its dispatch.
 */
@NullMarked
package org.toqa.fleet.manager;

import org.jspecify.annotations.NullMarked;
