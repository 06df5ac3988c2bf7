/** What every port to the database may throw. */
@NullMarked
package org.toqa.persistence;

import org.jspecify.annotations.NullMarked;
