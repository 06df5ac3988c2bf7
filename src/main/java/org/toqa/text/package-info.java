/** Text that came from elsewhere, made fit for logs and pages. */
@NullMarked
package org.toqa.text;

import org.jspecify.annotations.NullMarked;
