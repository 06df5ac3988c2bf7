/** HTTP to addresses that people have typed, and that may lead anywhere. */
@NullMarked
package org.toqa.outbound;

import org.jspecify.annotations.NullMarked;
