#include "settings.h"

struct settings settings_default(void)
{
    struct settings settings = {
        .wheel_radius_um = SETTINGS_WHEEL_RADIUS_UM,
        .centre_to_wheel_um = SETTINGS_CENTRE_TO_WHEEL_UM,
    };

    for (uint8_t i = 0; i < BODY_FLOOR_SENSORS; i++) {
        settings.floor_mv[i] = SETTINGS_FLOOR_MV;
    }
    return settings;
}

static bool is_within(uint32_t value, uint32_t least, uint32_t most)
{
    return value >= least && value <= most;
}

bool settings_are_good(const struct settings *settings)
{
    for (uint8_t i = 0; i < BODY_FLOOR_SENSORS; i++) {
        if (!is_within(settings->floor_mv[i], SETTINGS_LEAST_FLOOR_MV, SETTINGS_MOST_FLOOR_MV)) {
            return false;
        }
    }
    return is_within(settings->wheel_radius_um, SETTINGS_LEAST_WHEEL_RADIUS_UM,
                     SETTINGS_MOST_WHEEL_RADIUS_UM) &&
           is_within(settings->centre_to_wheel_um, SETTINGS_LEAST_CENTRE_TO_WHEEL_UM,
                     SETTINGS_MOST_CENTRE_TO_WHEEL_UM);
}

bool settings_are_same(const struct settings *some, const struct settings *others)
{
    for (uint8_t i = 0; i < BODY_FLOOR_SENSORS; i++) {
        if (some->floor_mv[i] != others->floor_mv[i]) {
            return false;
        }
    }
    return some->wheel_radius_um == others->wheel_radius_um &&
           some->centre_to_wheel_um == others->centre_to_wheel_um;
}
