/**
 * Cameras of floors and robots: where each is, and its picture of now, fetched for many who look by
 * one request a moment.
 */
@NullMarked
package org.toqa.camera;

import org.jspecify.annotations.NullMarked;
