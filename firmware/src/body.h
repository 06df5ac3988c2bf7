/* The robot's measures. Those of settings.h are to be measured on the robot, and are sent to it. */
#ifndef BODY_H
#define BODY_H

/* Gear 1:27, 26 pulses a motor turn, quadrature times 4. */
#define BODY_COUNTS_PER_TURN (27 * 26 * 4)

/* The motors' rated speed, in wheel turns a minute. */
#define BODY_RATED_RPM 220

/*
 * The fastest that a wheel is commanded to turn, in wheel turns a minute; 0.63 m/s: a loaded robot
 * is braked from it in 50 ms, and voltage is left to correct with.
 */
#define BODY_MAX_RPM 150

#define BODY_WHEELS 3

#define BODY_FLOOR_SENSORS 5

#endif
