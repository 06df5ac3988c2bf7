/* Approaches a velocity no faster than the motors can change theirs. */
#ifndef SLEW_H
#define SLEW_H

#include <stdint.h>

#include "twist.h"

void slew_towards(struct twist *twist, const struct twist *wanted, uint16_t ms);

#endif
