/** The one table of routes (method, path, permission, handler) and the filters that ask it. */
@NullMarked
package org.toqa.web.route;

import org.jspecify.annotations.NullMarked;
