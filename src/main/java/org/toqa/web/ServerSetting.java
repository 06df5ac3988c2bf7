package org.toqa.web;

import org.jspecify.annotations.Nullable;

/**
 * A setting of the server's configuration, as the page of settings shows it.
 *
 * @param key as {@code docs/configuration.md} names it
 * @param value null: it is secret, and given
 * @param origin where it was written, such as {@code TOQA_PORT}; null: it is the default
 * @param allowed what it may be, in English
 */
public record ServerSetting(
    String key, @Nullable String value, @Nullable String origin, String allowed) {}
