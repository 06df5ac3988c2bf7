/** Many robots on one floor: who may drive where, and when. */
@NullMarked
package org.toqa.traffic;

import org.jspecify.annotations.NullMarked;
