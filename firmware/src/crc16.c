#include "crc16.h"

/* Eight steps of the shift register at once, byte by byte; needs no table. */
uint16_t crc16(const uint8_t *bytes, uint8_t length)
{
    uint8_t high = 0xFF;
    uint8_t low = 0xFF;

    for (uint8_t i = 0; i < length; i++) {
        uint8_t x = high ^ bytes[i];

        x ^= (uint8_t)(x >> 4);
        high = (uint8_t)(low ^ (uint8_t)(x << 4) ^ (x >> 3));
        low = (uint8_t)(x ^ (uint8_t)(x << 5));
    }
    return (uint16_t)((uint16_t)((uint16_t)high << 8) | low);
}
