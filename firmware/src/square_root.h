/* The whole part of a square root. */
#ifndef SQUARE_ROOT_H
#define SQUARE_ROOT_H

#include <stdint.h>

uint16_t square_root(uint32_t square);

#endif
