/** What an experiment is: what it is given, and what it reports. */
@NullMarked
package org.toqa.lab.experiment;

import org.jspecify.annotations.NullMarked;
