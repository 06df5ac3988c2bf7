/**
 * A swarm that keeps its shape behind a virtual leader and sees by three of its lidars (Toibazarov,
 * Baiseitov, Kyzyrkanov, Aljavarneh, Atanov 2023). Values in, values out.
 */
@NullMarked
package org.toqa.formation.swarm;

import org.jspecify.annotations.NullMarked;
