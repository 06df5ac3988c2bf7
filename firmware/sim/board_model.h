/*
 * The wires between the simulated chip's pins and what is soldered around it (src/avr/board.h); the
 * motors are wired apart, see drive_model.h.
 */
#ifndef BOARD_MODEL_H
#define BOARD_MODEL_H

#include <simavr/sim_avr.h>

#include "chip.h"

struct board_model {
    avr_t *avr;
    struct lcd_model *lcd;
    const struct surroundings *surroundings;
    uint8_t lcd_lines; /* as they were last */
    uint8_t range_message[8];
    uint8_t range_sent; /* bytes of it */
};

/* Begins to wire; board must last as long as the chip. */
void board_model_wire(struct board_model *board);

/* After every reset of the chip. */
void board_model_restart(struct board_model *board);

/* Puts the surroundings on the pins. */
void board_model_update(struct board_model *board);

#endif
