/*
 * Where the robot is by its encoder counts, since the start. The heading follows from the sum of
 * all counts and gathers no rounding; places are as exact as pose_advance says.
 */
#ifndef ODOMETRY_H
#define ODOMETRY_H

#include <stdint.h>

#include "body.h"
#include "pose.h"

struct odometry {
    int32_t counts[BODY_WHEELS]; /* at the last update */
    int64_t turned;              /* counts of all wheels together */
    struct pose pose;
};

/* counts: of the encoders where the robot is now, which becomes the origin. */
void odometry_begin(struct odometry *odometry, const int32_t counts[BODY_WHEELS]);

/* To be called at least every 20 ms while wheels turn; a counter may have wrapped around. */
void odometry_update(struct odometry *odometry, const int32_t counts[BODY_WHEELS]);

#endif
