/** The simulated world: virtual time, floors and bodies of robots for real daemons. */
@NullMarked
package org.toqa.sim;

import org.jspecify.annotations.NullMarked;
