@NullMarked
package org.toqa.wording;

import org.jspecify.annotations.NullMarked;
