#include "arm_settings.h"

#include <string.h>

static bool is_pulse(uint16_t us)
{
    return us >= ARM_LEAST_PULSE_US && us <= ARM_MOST_PULSE_US;
}

static bool is_apart(uint16_t one, uint16_t other, uint16_t least)
{
    return (one < other ? other - one : one - other) >= least;
}

static bool is_good_joint(const struct arm_joint_settings *joint)
{
    return joint->least_urad >= -ARM_MOST_ANGLE_URAD && joint->most_urad <= ARM_MOST_ANGLE_URAD &&
           joint->least_urad <= ARM_MOST_ANGLE_URAD - ARM_LEAST_SPAN_URAD &&
           joint->most_urad >= joint->least_urad + ARM_LEAST_SPAN_URAD &&
           joint->rate_mrad_s >= ARM_LEAST_RATE && joint->rate_mrad_s <= ARM_MOST_RATE &&
           joint->acceleration_mrad_s2 >= ARM_LEAST_RATE && is_pulse(joint->pulse_least_us) &&
           is_pulse(joint->pulse_most_us) &&
           is_apart(joint->pulse_least_us, joint->pulse_most_us, ARM_LEAST_PULSES_US) &&
           joint->mv_least <= ARM_MOST_MV && joint->mv_most <= ARM_MOST_MV &&
           is_apart(joint->mv_least, joint->mv_most, ARM_LEAST_SPAN_MV);
}

bool arm_settings_are_good(const struct arm_settings *settings)
{
    for (uint8_t i = 0; i < ARM_JOINTS; i++) {
        if (!is_good_joint(&settings->joints[i])) {
            return false;
        }
    }
    return is_pulse(settings->open_us) && is_pulse(settings->closed_us) &&
           settings->empty_mv <= ARM_MOST_MV && settings->mv_a_kg >= ARM_LEAST_MV_A_KG &&
           settings->mv_a_kg <= ARM_MOST_MV;
}

/* They have no gaps. */
bool arm_settings_are_same(const struct arm_settings *some, const struct arm_settings *others)
{
    return memcmp(some, others, sizeof *some) == 0;
}
