/**
 * A supervisor and workers that carry boxes together (CMCT: Elsonbaty, Rizk, Elksas and Salem, "A
 * Cooperative Multi-Robot Control Using Ad Hoc Wireless Network"): what is ordered when, as
 * functions over values; and the same workers without a supervisor. Nothing here knows of links or
 * bodies.
 */
@NullMarked
package org.toqa.cooperation;

import org.jspecify.annotations.NullMarked;
