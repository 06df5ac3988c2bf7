/* A velocity in the robot's frame: x forward, y left, w counter-clockwise. */
#ifndef TWIST_H
#define TWIST_H

#include <stdint.h>

#define TWIST_SPEED_LIMIT_UM_S INT32_C(1000000)
#define TWIST_TURN_LIMIT_URAD_S INT32_C(10000000)

struct twist {
    int32_t vx_um_s;
    int32_t vy_um_s;
    int32_t w_urad_s;
};

#endif
