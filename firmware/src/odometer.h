/*
 * Where the robot is by its encoder counts, since the start. The heading follows from the sum of
 * all counts and gathers no rounding; places are as exact as pose_advance says.
 */
#ifndef ODOMETER_H
#define ODOMETER_H

#include <stdint.h>

#include "body.h"
#include "pose.h"

struct odometer {
    int32_t counts[BODY_WHEELS]; /* at the last update */
    int64_t turned;              /* counts of all wheels together */
    struct pose pose;
};

/* counts: what the encoders say where the robot stands now, which becomes the origin. */
void odometer_begin(struct odometer *odometer, const int32_t counts[BODY_WHEELS]);

/* To be called at least every 20 ms while wheels turn; a counter may have wrapped around. */
void odometer_update(struct odometer *odometer, const int32_t counts[BODY_WHEELS]);

#endif
