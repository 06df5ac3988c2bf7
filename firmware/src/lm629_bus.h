/* The 8-bit bus to three LM629, axis 0 to 2: on the robot pins, on a PC a model. */
#ifndef LM629_BUS_H
#define LM629_BUS_H

#include <stdint.h>

/* Holds the reset line of all three low for 8 clocks of theirs, and waits 2 ms. */
void lm629_bus_reset(void);

void lm629_bus_command(uint8_t axis, uint8_t command);
void lm629_bus_write(uint8_t axis, uint8_t data);
uint8_t lm629_bus_status(uint8_t axis);
uint8_t lm629_bus_read(uint8_t axis);

#endif
