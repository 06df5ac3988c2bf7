/*
 * What differs from robot to robot: its wheels, and when its floor sensors see a floor. The daemon
 * sends it, and the EEPROM keeps it. Within these bounds no product of the firmware is too large for
 * its type; the tests drive the kinematics at each of them.
 */
#ifndef SETTINGS_H
#define SETTINGS_H

#include <stdbool.h>
#include <stdint.h>

#include "body.h"

#define SETTINGS_WHEEL_RADIUS_UM 40000
#define SETTINGS_CENTRE_TO_WHEEL_UM 100000
#define SETTINGS_FLOOR_MV 1000

#define SETTINGS_LEAST_WHEEL_RADIUS_UM 10000
#define SETTINGS_MOST_WHEEL_RADIUS_UM 65000
#define SETTINGS_LEAST_CENTRE_TO_WHEEL_UM 30000
#define SETTINGS_MOST_CENTRE_TO_WHEEL_UM 500000
#define SETTINGS_LEAST_FLOOR_MV 100
#define SETTINGS_MOST_FLOOR_MV 4900

struct settings {
    uint32_t wheel_radius_um;
    uint32_t centre_to_wheel_um;
    uint16_t floor_mv[BODY_FLOOR_SENSORS]; /* below this a sensor sees no floor */
};

/* Of a robot that nobody has measured. */
struct settings settings_default(void);

bool settings_are_good(const struct settings *settings);

bool settings_are_same(const struct settings *some, const struct settings *others);

#endif
