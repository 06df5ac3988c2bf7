/**
 * What people and programs enter, from forms, JSON and tables: read, checked, answered in
 * sentences.
 */
@NullMarked
package org.toqa.web.input;

import org.jspecify.annotations.NullMarked;
