/* Three wheels with their motors, and where they carry the body. */
#ifndef RIG_H
#define RIG_H

#include "motor.h"

enum { RIG_WHEELS = 3 };

struct rig {
    struct motor motors[RIG_WHEELS];
    double x; /* metres, where the body really is, from where it began */
    double y;
    double theta; /* radians, counter-clockwise, not wrapped */
};

/* duties: -1 to 1, held for so many seconds. */
void rig_turn(struct rig *rig, const double duties[RIG_WHEELS], double seconds);

/* Metres a second at the rim of the fastest wheel. */
double rig_fastest_rim(const struct rig *rig);

#endif
