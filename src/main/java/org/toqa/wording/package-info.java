/**
 * What the fleet says to people: a phrase and its values, read in a language at the last moment.
 */
@NullMarked
package org.toqa.wording;

import org.jspecify.annotations.NullMarked;
