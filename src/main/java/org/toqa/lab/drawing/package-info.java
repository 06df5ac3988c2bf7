/** Charts and scenes of the laboratory, drawn as SVG. */
@NullMarked
package org.toqa.lab.drawing;

import org.jspecify.annotations.NullMarked;
