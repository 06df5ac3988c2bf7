/*
 * Binary angles: 2^32 is a turn, counter-clockwise, so that they wrap around by themselves. Sine
 * and cosine are off by at most 6e-5.
 */
#ifndef ANGLE_H
#define ANGLE_H

#include <stdint.h>

#define ANGLE_QUARTER UINT32_C(0x40000000)

int16_t angle_sin_q15(uint32_t angle);
int16_t angle_cos_q15(uint32_t angle);

/* In (-pi, pi]. */
int32_t angle_urad(uint32_t angle);

/* urad: within 2^27 of 0. */
uint32_t angle_from_urad(int32_t urad);

#endif
