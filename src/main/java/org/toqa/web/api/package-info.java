/** The JSON API under /api/v1, and the live events. */
@NullMarked
package org.toqa.web.api;

import org.jspecify.annotations.NullMarked;
