#include "square_root.h"

/* Bit by bit, as on paper: 16 steps. */
uint16_t square_root(uint32_t square)
{
    uint32_t rest = square;
    uint32_t result = 0;

    for (uint32_t bit = UINT32_C(1) << 30; bit != 0; bit >>= 2) {
        if (rest >= result + bit) {
            rest -= result + bit;
            result = (result >> 1) + bit;
        } else {
            result >>= 1;
        }
    }
    return (uint16_t)result;
}
