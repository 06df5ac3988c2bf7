/*
 * Why the robot must be stopped. A reason comes with its cause and stays until it is cleared, by the
 * daemon or only by a person; while its cause lasts, nobody clears it.
 */
#ifndef STOP_H
#define STOP_H

#include <stdbool.h>
#include <stdint.h>

enum stop_reason {
    STOP_POWER_UP = 1U << 0,
    STOP_LINK = 1U << 1,
    STOP_SWITCH = 1U << 2,
    STOP_EDGE = 1U << 3,
    STOP_HEAT = 1U << 4,
    STOP_BATTERY = 1U << 5,
    STOP_STALL = 1U << 6,
    STOP_DRIVE = 1U << 7,
    STOP_WATCHDOG = 1U << 8,
};

enum {
    STOP_REASONS = 9,
    STOP_LINK_MS = 200, /* without a good frame */
};

struct stop {
    uint16_t reasons;
    uint16_t causes; /* that last now */
};

/* After a start the robot is stopped; reason: STOP_POWER_UP or STOP_WATCHDOG. */
void stop_begin(struct stop *stop, enum stop_reason reason);

/* Sets whether a cause is present now. */
void stop_set_cause(struct stop *stop, enum stop_reason reason, bool is_present);

/* Returns whether all of these reasons are gone now. */
bool stop_clear(struct stop *stop, uint16_t reasons, bool by_person);

/* The text for the most severe reason, for the display; empty when nothing stops the robot. */
const char *stop_text(uint16_t reasons);

#endif
