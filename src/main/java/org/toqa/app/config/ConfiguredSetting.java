package org.toqa.app.config;

import org.jspecify.annotations.Nullable;

/**
 * What one setting is, as somebody gave it or by default, to be shown.
 *
 * @param key in the file; a dot stands for a level of nesting
 * @param value null: it is secret, and given
 * @param origin where it was written; null: nowhere, it is the default
 * @param allowed what it may be, in English, for a sentence
 */
public record ConfiguredSetting(
    String key, @Nullable String value, @Nullable String origin, String allowed) {}
