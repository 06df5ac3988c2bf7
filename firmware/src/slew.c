#include "slew.h"

/* 1.5 m/s2 and 15 rad/s2. */
static const int32_t ACCELERATION_UM_S_MS = 1500;
static const int32_t TURN_ACCELERATION_URAD_S_MS = 15000;

static int32_t approached(int32_t value, int32_t wanted, int32_t change)
{
    if (wanted - value > change) {
        return value + change;
    }
    return value - wanted > change ? value - change : wanted;
}

void slew_towards(struct twist *twist, const struct twist *wanted, uint16_t ms)
{
    int32_t change_um_s = ACCELERATION_UM_S_MS * ms;
    int32_t change_urad_s = TURN_ACCELERATION_URAD_S_MS * ms;

    twist->vx_um_s = approached(twist->vx_um_s, wanted->vx_um_s, change_um_s);
    twist->vy_um_s = approached(twist->vy_um_s, wanted->vy_um_s, change_um_s);
    twist->w_urad_s = approached(twist->w_urad_s, wanted->w_urad_s, change_urad_s);
}
