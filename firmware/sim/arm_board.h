/*
 * A modelled arm: servos that turn to where the pulses of timer 3 tell them, potentiometers, a hand
 * that grasps a box wherever it closes, and the load sensor on it. What of it is wired to the chip the
 * multiplexer decides (src/avr/board.h).
 */
#ifndef ARM_BOARD_H
#define ARM_BOARD_H

#include <simavr/sim_avr.h>
#include <stdbool.h>
#include <stdint.h>

enum { ARM_BOARD_JOINTS = 2, ARM_BOARD_SERVOS = 3 };

struct arm_board {
    double shares[ARM_BOARD_SERVOS]; /* of 0.5 to 2.5 ms; of shoulder, elbow and hand */
    bool is_stuck;                   /* its joints do not turn */
    uint32_t box_g;                  /* what the hand grasps; 0: there is nothing */
    uint32_t load_g;                 /* on the hand */
    uint32_t grasps;                 /* how often it grasped something, and let something go */
    uint32_t releases;
    uint32_t cut_pulses; /* pulses during which the multiplexer was switched */
};

extern struct arm_board arm_board;

void arm_board_wire(avr_t *avr);

/* After every reset of the chip. */
void arm_board_restart(void);

#endif
