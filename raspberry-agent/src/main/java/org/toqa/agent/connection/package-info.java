/** Lines to and from the other end of a link. */
@NullMarked
package org.toqa.agent.connection;

import org.jspecify.annotations.NullMarked;
