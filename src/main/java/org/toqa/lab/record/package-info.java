/** Runs of experiments that people order: their queue, what is kept of each, and who may run. */
@NullMarked
package org.toqa.lab.record;

import org.jspecify.annotations.NullMarked;
