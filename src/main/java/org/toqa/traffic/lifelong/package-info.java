/** Traffic that never ends: step after step, for robots that get new goals as they arrive. */
@NullMarked
package org.toqa.traffic.lifelong;

import org.jspecify.annotations.NullMarked;
