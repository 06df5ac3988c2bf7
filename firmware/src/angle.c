#include "angle.h"

enum { QUARTER_STEPS = 128, QUARTER_STEP_BITS = 23 }; /* 2^30 = a quarter turn = 128 steps */

/* 2^15 sin of a quarter turn. */
static const uint16_t SINE[QUARTER_STEPS + 1] = {
    0, 402, 804, 1206, 1608, 2009, 2411, 2811, 3212, 3612, 4011, 4410,
    4808, 5205, 5602, 5998, 6393, 6787, 7180, 7571, 7962, 8351, 8740, 9127,
    9512, 9896, 10279, 10660, 11039, 11417, 11793, 12167, 12540, 12910, 13279, 13646,
    14010, 14373, 14733, 15091, 15447, 15800, 16151, 16500, 16846, 17190, 17531, 17869,
    18205, 18538, 18868, 19195, 19520, 19841, 20160, 20475, 20788, 21097, 21403, 21706,
    22006, 22302, 22595, 22884, 23170, 23453, 23732, 24008, 24279, 24548, 24812, 25073,
    25330, 25583, 25833, 26078, 26320, 26557, 26791, 27020, 27246, 27467, 27684, 27897,
    28106, 28311, 28511, 28707, 28899, 29086, 29269, 29448, 29622, 29792, 29957, 30118,
    30274, 30425, 30572, 30715, 30853, 30986, 31114, 31238, 31357, 31471, 31581, 31686,
    31786, 31881, 31972, 32058, 32138, 32214, 32286, 32352, 32413, 32470, 32522, 32568,
    32610, 32647, 32679, 32706, 32729, 32746, 32758, 32766, 32768,
};

static int16_t interpolated(uint32_t quarter)
{
    uint8_t step = (uint8_t)(quarter >> QUARTER_STEP_BITS);
    uint32_t low = SINE[step];
    uint32_t high = SINE[step == QUARTER_STEPS ? step : step + 1];
    uint32_t share = (quarter >> (QUARTER_STEP_BITS - 15)) & 0x7FFFU;
    uint32_t sine = low + (((high - low) * share + 0x4000U) >> 15);

    return (int16_t)(sine > INT16_MAX ? INT16_MAX : sine);
}

int16_t angle_sin_q15(uint32_t angle)
{
    uint32_t in_half = angle & 0x7FFFFFFFUL;
    uint32_t quarter = in_half > ANGLE_QUARTER ? 2 * ANGLE_QUARTER - in_half : in_half;
    int16_t sine = interpolated(quarter);

    return angle == in_half ? sine : (int16_t)-sine;
}

int16_t angle_cos_q15(uint32_t angle)
{
    return angle_sin_q15(angle + ANGLE_QUARTER);
}

int32_t angle_urad(uint32_t angle)
{
    /* 2 pi 10^6 = 6283185.3 urad a turn */
    return (int32_t)(((int64_t)(int32_t)angle * 6283185) >> 32);
}

uint32_t angle_from_urad(int32_t urad)
{
    /* 2^32 / (2 pi 10^6), times 2^24 */
    static const int64_t ANGLE_A_URAD_Q24 = INT64_C(11468322278);

    return (uint32_t)((urad * ANGLE_A_URAD_Q24) >> 24);
}
