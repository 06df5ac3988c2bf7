/* What differs from arm to arm; the daemon sends it, and the EEPROM keeps it. */
#ifndef ARM_SETTINGS_H
#define ARM_SETTINGS_H

#include <stdbool.h>
#include <stdint.h>

enum { ARM_JOINTS = 2 };

/* Angles: from 0, either way. */
#define ARM_MOST_ANGLE_URAD 6300000
#define ARM_LEAST_SPAN_URAD 10000

/* Of rates and accelerations, mrad/s and mrad/s2. */
#define ARM_LEAST_RATE 10
#define ARM_MOST_RATE 13000

#define ARM_LEAST_PULSE_US 400
#define ARM_MOST_PULSE_US 2600
#define ARM_LEAST_PULSES_US 100 /* between both ends */

#define ARM_MOST_MV 5000
#define ARM_LEAST_SPAN_MV 500
#define ARM_LEAST_MV_A_KG 100

/* Of least and most: where the joint stands farthest either way. */
struct arm_joint_settings {
    int32_t least_urad;
    int32_t most_urad;
    uint16_t rate_mrad_s; /* at most */
    uint16_t acceleration_mrad_s2;
    uint16_t pulse_least_us; /* of its servo */
    uint16_t pulse_most_us;
    uint16_t mv_least; /* of its potentiometer */
    uint16_t mv_most;
};

struct arm_settings {
    struct arm_joint_settings joints[ARM_JOINTS]; /* all 0: there is no arm */
    uint16_t open_us; /* of the hand's servo */
    uint16_t closed_us;
    uint16_t empty_mv; /* of the load sensor */
    uint16_t mv_a_kg;
};

bool arm_settings_are_good(const struct arm_settings *settings);

bool arm_settings_are_same(const struct arm_settings *some, const struct arm_settings *others);

#endif
