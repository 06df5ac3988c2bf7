/**
 * A supervisor and its workers on a floor (CMCT: Elsonbaty, Rizk, Elksas and Salem, "A Cooperative
 * Multi-Robot Control Using Ad Hoc Wireless Network"): a robot with cameras looks for boxes, and
 * each box that it finds becomes an ordinary task of the fleet.
 */
@NullMarked
package org.toqa.fleet.supervision;

import org.jspecify.annotations.NullMarked;
