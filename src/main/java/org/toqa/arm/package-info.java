/**
 * An arm of two links in the plane, as published for CMCT: where its hand is, how it comes to a
 * place, within which limits, and the steps of picking up and placing.
 */
@NullMarked
package org.toqa.arm;

import org.jspecify.annotations.NullMarked;
