/** SQL, and only here: the fleet's store on H2 and on MySQL. */
@NullMarked
package org.toqa.store;

import org.jspecify.annotations.NullMarked;
