package org.toqa.fleet;

import java.time.Instant;

/**
 * The template from which an order was made.
 *
 * @param changedAt when the template became what the order was made from
 * @param values of its parameters by their names, a JSON object
 */
public record TemplateUse(long template, String name, Instant changedAt, String values) {}
