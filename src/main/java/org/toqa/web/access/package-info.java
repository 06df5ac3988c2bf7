/** Who is there and what he may do: filters, logins, passwords. */
@NullMarked
package org.toqa.web.access;

import org.jspecify.annotations.NullMarked;
