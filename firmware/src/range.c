#include "range.h"

enum { BEGIN = 0xFF, SUM_AT = 7 };

static void clear_ranges(struct range *range)
{
    for (uint8_t i = 0; i < RANGE_SENSORS; i++) {
        range->mm[i] = RANGE_SILENT_MM;
    }
}

void range_begin(struct range *range)
{
    range->length = 0;
    range->silent_ms = 0;
    clear_ranges(range);
}

static bool is_sum_right(const uint8_t *message)
{
    unsigned sum = 0;

    for (uint8_t i = 1; i < SUM_AT; i++) {
        sum += message[i];
    }
    return (sum & 0x7FU) == message[SUM_AT];
}

static uint16_t distance_mm(const uint8_t *seven_bits)
{
    uint16_t mm = (uint16_t)((uint16_t)(seven_bits[0] << 7) | seven_bits[1]);

    return mm > RANGE_NOTHING_MM ? RANGE_NOTHING_MM : mm;
}

void range_take_byte(struct range *range, uint8_t byte)
{
    if (byte == BEGIN) {
        range->message[0] = byte;
        range->length = 1;
        return;
    }
    if (range->length == 0 || byte > 0x7F) {
        range->length = 0;
        return;
    }
    range->message[range->length++] = byte;
    if (range->length < RANGE_MESSAGE_LENGTH) {
        return;
    }
    range->length = 0;
    if (is_sum_right(range->message)) {
        for (uint8_t i = 0; i < RANGE_SENSORS; i++) {
            range->mm[i] = distance_mm(range->message + 1 + 2 * i);
        }
        range->silent_ms = 0;
    }
}

void range_elapse(struct range *range, uint16_t ms)
{
    if (range->silent_ms < RANGE_TIME_OUT_MS) {
        range->silent_ms = (uint16_t)(range->silent_ms + ms);
    } else {
        clear_ranges(range);
    }
}
