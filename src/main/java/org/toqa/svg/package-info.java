/** Writes pictures in SVG. */
@NullMarked
package org.toqa.svg;

import org.jspecify.annotations.NullMarked;
