/**
 * Whom an end of the robot link trusts: keys and certificates, TLS pinned to them, and the codes
 * that pairing exchanges them by.
 */
@NullMarked
package org.toqa.link.trust;

import org.jspecify.annotations.NullMarked;
