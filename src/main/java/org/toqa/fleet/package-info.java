/** The agents: manager, floors and robots; and the ports they need. */
@NullMarked
package org.toqa.fleet;

import org.jspecify.annotations.NullMarked;
