package org.toqa.web.input;

import org.jspecify.annotations.Nullable;

/**
 * What is wrong with one line of a table.
 *
 * @param line as an editor counts them, from 1
 * @param column null: the whole line
 * @param sentence what is wrong and what to do, for a person
 */
public record LineFault(long line, @Nullable String column, String sentence) {}
