/** What benches count and time: processor time, heap, latencies, waits and contacts. */
@NullMarked
package org.toqa.app.bench.meter;

import org.jspecify.annotations.NullMarked;
