#include "brake.h"

/* Before that the encoder is too coarse. */
enum { LEAST_MS_Q4 = 7 * 16, LEAST_LOST_Q4 = 2 * 16 };

static int32_t magnitude(int32_t value)
{
    return value < 0 ? -value : value;
}

void brake_begin_reversing(struct brake *brake, uint8_t wheel, int32_t counts, int32_t rate,
                   int32_t voltage)
{
    int32_t speed = magnitude(rate);

    brake->from[wheel] = counts;
    brake->rate_q12[wheel] = speed * 4096 / 1000;
    brake->share_q8[wheel] = 128 - 17 * speed / magnitude(voltage);
    brake->is_backward[wheel] = rate < 0;
}

/* Half a count more, since whole ones are counted. */
static int32_t distance_q4(const struct brake *brake, uint8_t wheel, int32_t counts)
{
    int32_t moved = counts - brake->from[wheel];

    return 16 * (brake->is_backward[wheel] ? -moved : moved) + 8;
}

static int32_t unbraked_distance_q4(const struct brake *brake, uint8_t wheel, uint16_t ms_q4)
{
    return (brake->rate_q12[wheel] * ms_q4) >> 12;
}

bool brake_has_stopped(const struct brake *brake, uint8_t wheel, int32_t counts, uint16_t ms_q4)
{
    int32_t unbraked_q4 = unbraked_distance_q4(brake, wheel, ms_q4);

    return ms_q4 >= BRAKE_MAX_MS_Q4 ||
           (ms_q4 >= LEAST_MS_Q4 &&
            distance_q4(brake, wheel, counts) <= (unbraked_q4 * brake->share_q8[wheel]) >> 8);
}

uint16_t brake_end_ms_q4(const struct brake *brake, uint8_t wheel, int32_t counts, uint16_t ms_q4)
{
    int32_t unbraked_q4 = unbraked_distance_q4(brake, wheel, ms_q4);
    int32_t lost_q4 = unbraked_q4 - distance_q4(brake, wheel, counts);
    int32_t end_ms_q4;

    if (ms_q4 < LEAST_MS_Q4 || lost_q4 < LEAST_LOST_Q4) {
        return BRAKE_MAX_MS_Q4;
    }
    /* the distance that is lost grows with the square of the time */
    end_ms_q4 = ((unbraked_q4 * ms_q4 / lost_q4) * (256 - brake->share_q8[wheel])) >> 8;
    return (uint16_t)(end_ms_q4 > BRAKE_MAX_MS_Q4 ? BRAKE_MAX_MS_Q4 : end_ms_q4);
}
