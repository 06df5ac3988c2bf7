/**
 * Says when tasks will be picked up and delivered, as far as that can be said, and why not else.
 */
@NullMarked
package org.toqa.forecast;

import org.jspecify.annotations.NullMarked;
