/** What several commands ask for on their command lines: files, numbers, points, moves. */
@NullMarked
package org.toqa.app.command;

import org.jspecify.annotations.NullMarked;
