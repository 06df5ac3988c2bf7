/** The daemon on each robot: connections, segment runner, journal and chassis. */
@NullMarked
package org.toqa.agent;

import org.jspecify.annotations.NullMarked;
