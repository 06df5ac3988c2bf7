/*
 * A place and a heading. One step is taken as a straight line along the heading in its middle: a
 * step that turns by 35 mrad is too long by 5e-5 of its length, and rounding adds at most 1e-4.
 */
#ifndef POSE_H
#define POSE_H

#include <stdint.h>

struct pose {
    int64_t x_um_q16; /* um times 2^16 */
    int64_t y_um_q16;
    uint32_t heading; /* 2^32 a turn, from the x axis */
};

/* A motion of some milliseconds in the frame of the one who moves: x forward, y left; 8 m at most. */
struct step {
    int32_t x_um_q8;
    int32_t y_um_q8;
    int32_t turn; /* 2^32 a turn */
};

void pose_advance(struct pose *pose, const struct step *step);

/* Turns a vector by an angle; neither may be as much as 2^30. */
void pose_rotate(int32_t *x, int32_t *y, uint32_t angle);

static inline int32_t pose_um(int64_t um_q16)
{
    return (int32_t)(um_q16 >> 16);
}

#endif
