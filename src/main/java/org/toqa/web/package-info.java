/** HTTP, and only here: pages, API and live events. */
@NullMarked
package org.toqa.web;

import org.jspecify.annotations.NullMarked;
