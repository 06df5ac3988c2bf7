/* Battery, floor sensors and alarms. */
#ifndef SENSORS_H
#define SENSORS_H

#include "robot.h"

/* Measures every channel once. */
void sensors_begin(struct robot_inputs *inputs);

/* Every millisecond: takes the next channel's value, without waiting for it. */
void sensors_sample(struct robot_inputs *inputs);

/* The next one shall be that of the arm. */
void sensors_ask_arm(void);

/* Returns whether that was measured since it was asked for. */
bool sensors_take_arm(uint16_t *mv);

#endif
