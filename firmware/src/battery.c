#include "battery.h"

void battery_begin(struct battery *battery)
{
    battery->mv_q4 = 0;
    battery->low_ms = 0;
}

void battery_update(struct battery *battery, uint16_t mv, uint16_t ms_since_last)
{
    if (battery->mv_q4 == 0) {
        battery->mv_q4 = (uint32_t)mv << 4;
    } else {
        battery->mv_q4 += mv - (battery->mv_q4 >> 4);
    }
    if (battery_mv(battery) >= BATTERY_LOW_MV) {
        battery->low_ms = 0;
    } else if (battery->low_ms < BATTERY_LOW_MS) {
        battery->low_ms = (uint16_t)(battery->low_ms + ms_since_last);
    }
}
