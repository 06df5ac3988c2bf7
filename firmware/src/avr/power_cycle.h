/* Counts the starts, in EEPROM: 1 on a chip that was erased. Good for 100,000 starts. */
#ifndef POWER_CYCLE_H
#define POWER_CYCLE_H

#include <stdint.h>

uint16_t power_cycle_count(void);

#endif
