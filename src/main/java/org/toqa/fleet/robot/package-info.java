/** The robot agents: each owns the link to its robot, and tells its floor what it hears. */
@NullMarked
package org.toqa.fleet.robot;

import org.jspecify.annotations.NullMarked;
