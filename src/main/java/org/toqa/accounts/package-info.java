/**
 * Users and their rights: accounts, roles, sessions, tokens and their scopes, password rules; and
 * the ports they need.
 */
@NullMarked
package org.toqa.accounts;

import org.jspecify.annotations.NullMarked;
