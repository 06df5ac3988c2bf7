/** Server-sent events: snapshots of the fleet, and what changed in them. */
@NullMarked
package org.toqa.web.live;

import org.jspecify.annotations.NullMarked;
