/** Experiments of CSM-MAMRS: one robot with two wheels on each of three floors. */
@NullMarked
package org.toqa.lab.csm;

import org.jspecify.annotations.NullMarked;
