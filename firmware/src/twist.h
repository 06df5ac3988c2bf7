/* A velocity in the robot's frame: x forward, y left, w counter-clockwise. */
#ifndef TWIST_H
#define TWIST_H

#include <stdint.h>

enum {
    TWIST_SPEED_LIMIT_UM_S = 1000000,
    TWIST_TURN_LIMIT_URAD_S = 10000000,
};

struct twist {
    int32_t vx_um_s;
    int32_t vy_um_s;
    int32_t w_urad_s;
};

#endif
