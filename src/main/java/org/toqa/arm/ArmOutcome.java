package org.toqa.arm;

import org.jspecify.annotations.Nullable;

/**
 * How an action of an arm ended.
 *
 * @param failure null: it is done
 * @param weight kilograms of what it grasped; null: it has weighed nothing
 */
public record ArmOutcome(@Nullable ArmFailure failure, @Nullable Double weight) {}
