/** The pages: servlets that read a form and choose a view; the views print. */
@NullMarked
package org.toqa.web.page;

import org.jspecify.annotations.NullMarked;
