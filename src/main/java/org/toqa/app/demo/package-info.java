/** {@code toqa demo}: simulated robots at work, and the tasks that they are given. */
@NullMarked
package org.toqa.app.demo;

import org.jspecify.annotations.NullMarked;
