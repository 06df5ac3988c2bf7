/** Starts the executable WAR before any library is on the class path. */
@NullMarked
package org.toqa.launch;

import org.jspecify.annotations.NullMarked;
