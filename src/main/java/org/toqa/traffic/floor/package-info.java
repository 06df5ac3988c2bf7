/**
 * Traffic on a real floor: paths of discs in metres, released piece by piece so that delay never
 * becomes danger.
 */
@NullMarked
package org.toqa.traffic.floor;

import org.jspecify.annotations.NullMarked;
