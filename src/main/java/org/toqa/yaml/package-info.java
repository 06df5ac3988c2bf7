/** Files that people write in YAML: how they are read, and what a wrong word may have meant. */
@NullMarked
package org.toqa.yaml;

import org.jspecify.annotations.NullMarked;
