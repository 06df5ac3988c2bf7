/* Battery, floor sensors and alarms. */
#ifndef SENSORS_H
#define SENSORS_H

#include "robot.h"

/* Measures every channel once. */
void sensors_begin(struct robot_inputs *inputs);

/* Every millisecond: takes the next channel's value, without waiting for it. */
void sensors_sample(struct robot_inputs *inputs);

#endif
