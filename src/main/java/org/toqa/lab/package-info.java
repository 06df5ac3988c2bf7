/**
 * The laboratory: published experiments on what Toqa implements, each with its figures beside ours
 * and a verdict.
 */
@NullMarked
package org.toqa.lab;

import org.jspecify.annotations.NullMarked;
