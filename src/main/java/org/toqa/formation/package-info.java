/** Robots that carry one load together: shapes, followers' laws, and when a formation must stop. */
@NullMarked
package org.toqa.formation;

import org.jspecify.annotations.NullMarked;
