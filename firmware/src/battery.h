/* The battery's voltage, smoothed; a motor that starts pulls it down for a moment. */
#ifndef BATTERY_H
#define BATTERY_H

#include <stdbool.h>
#include <stdint.h>

enum {
    BATTERY_LOW_MV = 13200, /* four cells of 3.3 V */
    BATTERY_LOW_MS = 1000,
};

struct battery {
    uint32_t mv_q4; /* 0 before the first measurement */
    uint16_t low_ms;
};

void battery_begin(struct battery *battery);
void battery_update(struct battery *battery, uint16_t mv, uint16_t ms_since_last);

static inline uint16_t battery_mv(const struct battery *battery)
{
    return (uint16_t)(battery->mv_q4 >> 4);
}

/* Low for so long that it is not a motor that starts. */
static inline bool battery_is_low(const struct battery *battery)
{
    return battery->low_ms >= BATTERY_LOW_MS;
}

#endif
