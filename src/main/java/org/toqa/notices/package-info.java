/** What needs attention, told to the people who chose to be told: once, with its end. */
@NullMarked
package org.toqa.notices;

import org.jspecify.annotations.NullMarked;
