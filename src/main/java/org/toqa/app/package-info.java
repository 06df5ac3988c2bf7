/** The command line, the configuration, and the wiring of everything. */
@NullMarked
package org.toqa.app;

import org.jspecify.annotations.NullMarked;
