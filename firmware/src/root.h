/* The whole part of a square root. */
#ifndef ROOT_H
#define ROOT_H

#include <stdint.h>

uint16_t root(uint32_t square);

#endif
