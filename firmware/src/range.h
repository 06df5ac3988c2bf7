/*
 * The PSD range sensors. Their board sends, 20 times a second, 8 bytes: 0xFF, three distances in mm
 * as two bytes of 7 bits (the high one first), and the sum of these six modulo 128. So 0xFF is
 * found at the beginning only.
 */
#ifndef RANGE_H
#define RANGE_H

#include <stdbool.h>
#include <stdint.h>

enum {
    RANGE_SENSORS = 3,
    RANGE_NOTHING_MM = 800, /* nothing within the sensors' reach */
    RANGE_TIME_OUT_MS = 250,
    RANGE_MESSAGE_LENGTH = 8,
};

#define RANGE_SILENT_MM UINT16_MAX

struct range {
    uint8_t message[RANGE_MESSAGE_LENGTH];
    uint8_t length;
    uint16_t silent_ms;
    uint16_t mm[RANGE_SENSORS];
};

void range_begin(struct range *range);
void range_take_byte(struct range *range, uint8_t byte);
void range_elapse(struct range *range, uint16_t ms);

#endif
