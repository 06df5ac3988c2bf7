#include "stall.h"

#include <string.h>

enum {
    PERIOD_MS = 300,
    /* counts in a period; a wheel that is commanded to turn less may stand: 9 mm/s */
    MIN_COMMANDED_Q8 = 30 * 256,
};

static uint32_t magnitude(int32_t value)
{
    return value < 0 ? 0 - (uint32_t)value : (uint32_t)value;
}

void stall_begin(struct stall *stall, const int32_t counts[BODY_WHEELS])
{
    memset(stall, 0, sizeof *stall);
    memcpy(stall->last_counts, counts, sizeof stall->last_counts);
}

static bool is_stalled(const struct stall *stall)
{
    for (uint8_t i = 0; i < BODY_WHEELS; i++) {
        uint32_t commanded_q8 = stall->commanded_q8_ms[i] / 1000;

        if (commanded_q8 > MIN_COMMANDED_Q8 && stall->counted[i] < commanded_q8 >> 10) {
            return true;
        }
    }
    return false;
}

bool stall_update(struct stall *stall, const struct wheel_rates *rates,
                 const int32_t counts[BODY_WHEELS], uint16_t ms)
{
    bool stalled;

    for (uint8_t i = 0; i < BODY_WHEELS; i++) {
        int32_t moved = (int32_t)((uint32_t)counts[i] - (uint32_t)stall->last_counts[i]);

        stall->commanded_q8_ms[i] += magnitude(rates->q8[i]) * ms;
        stall->counted[i] += magnitude(moved);
        stall->last_counts[i] = counts[i];
    }
    stall->elapsed_ms = (uint16_t)(stall->elapsed_ms + ms);
    if (stall->elapsed_ms < PERIOD_MS) {
        return false;
    }
    stalled = is_stalled(stall);
    stall_begin(stall, counts);
    return stalled;
}
