/** The experiments with four agents in one robot: the scenes of the paper, and generated ones. */
@NullMarked
package org.toqa.lab.fouragents;

import org.jspecify.annotations.NullMarked;
