/* What is soldered between the chip and its motors: the other end of src/drive.h. */
#ifndef DRIVE_MODEL_H
#define DRIVE_MODEL_H

#include <simavr/sim_avr.h>

#include "rig.h"

struct drive_model {
    double seconds; /* of a step */

    /* Begins to wire; chip and motors must last as long. */
    void (*wire)(avr_t *avr, struct rig *rig);

    /* After every reset of the chip. */
    void (*restart)(void);

    /* At the end of every step: turns the motors through the next one. */
    void (*turn)(void);
};

#endif
