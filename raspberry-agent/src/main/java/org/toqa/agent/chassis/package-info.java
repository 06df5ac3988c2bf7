/** What moves: the body under a daemon, real or simulated, behind one interface. */
@NullMarked
package org.toqa.agent.chassis;

import org.jspecify.annotations.NullMarked;
