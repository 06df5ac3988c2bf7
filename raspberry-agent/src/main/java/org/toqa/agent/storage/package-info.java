/** What outlives the daemon: its data folder and the journal of its drives. */
@NullMarked
package org.toqa.agent.storage;

import org.jspecify.annotations.NullMarked;
