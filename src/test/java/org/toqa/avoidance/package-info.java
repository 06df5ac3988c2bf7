@NullMarked
package org.toqa.avoidance;

import org.jspecify.annotations.NullMarked;
