/*
 * Where the robot is by its encoder counts, since the start. The heading follows from the sum of
 * all counts and gathers no rounding; places are as exact as pose_advance says.
 */
#ifndef ODOMETRY_H
#define ODOMETRY_H

#include <stdint.h>

#include "body.h"
#include "pose.h"
#include "settings.h"

/* Of a robot's wheels. */
struct odometry_scale {
    int32_t along_q24; /* um a count, see odometry.c */
    int32_t aside_q24;
    uint64_t heading_q16; /* of 2^32 a turn, a count */
};

struct odometry {
    struct odometry_scale scale;
    int32_t counts[BODY_WHEELS]; /* at the last update */
    int64_t turned;              /* counts of all wheels together, since the heading was first */
    uint32_t first_heading;
    struct pose pose;
};

/* counts: of the encoders where the robot is now, which becomes the origin. */
void odometry_begin(struct odometry *odometry, const int32_t counts[BODY_WHEELS],
                    const struct settings *settings);

/* From here on the wheels are others; place and heading stay. */
void odometry_set_wheels(struct odometry *odometry, const struct settings *settings);

/* To be called at least every 20 ms while wheels turn; a counter may have wrapped around. */
void odometry_update(struct odometry *odometry, const int32_t counts[BODY_WHEELS]);

#endif
