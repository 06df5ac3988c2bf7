/** What robots measure and publish: what is believed of it, its limits, and who may publish it. */
@NullMarked
package org.toqa.telemetry;

import org.jspecify.annotations.NullMarked;
