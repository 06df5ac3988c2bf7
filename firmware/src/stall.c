#include "stall.h"

#include <string.h>

enum {
    WATCH_MS = 300,
    SLOW_Q8 = 30 * 256, /* counts in a watch; a wheel told to turn less may stand: 9 mm/s */
};

static uint32_t magnitude(int32_t value)
{
    return value < 0 ? 0 - (uint32_t)value : (uint32_t)value;
}

void stall_begin(struct stall *stall, const int32_t counts[BODY_WHEELS])
{
    memset(stall, 0, sizeof *stall);
    memcpy(stall->last, counts, sizeof stall->last);
}

static bool is_stalled(const struct stall *stall)
{
    for (uint8_t i = 0; i < BODY_WHEELS; i++) {
        uint32_t told_q8 = stall->told_q8_ms[i] / 1000;

        if (told_q8 > SLOW_Q8 && stall->turned[i] < told_q8 >> 10) {
            return true;
        }
    }
    return false;
}

bool stall_watch(struct stall *stall, const struct wheel_rates *rates,
                 const int32_t counts[BODY_WHEELS], uint16_t ms)
{
    bool stalled;

    for (uint8_t i = 0; i < BODY_WHEELS; i++) {
        int32_t moved = (int32_t)((uint32_t)counts[i] - (uint32_t)stall->last[i]);

        stall->told_q8_ms[i] += magnitude(rates->q8[i]) * ms;
        stall->turned[i] += magnitude(moved);
        stall->last[i] = counts[i];
    }
    stall->watched_ms = (uint16_t)(stall->watched_ms + ms);
    if (stall->watched_ms < WATCH_MS) {
        return false;
    }
    stalled = is_stalled(stall);
    stall_begin(stall, counts);
    return stalled;
}
