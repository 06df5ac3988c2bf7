/* Three wheels with their controllers, and where they carry the body. */
#ifndef RIG_H
#define RIG_H

#include "lm629_model.h"

enum { RIG_WHEELS = 3 };

struct rig {
    struct lm629_model wheels[RIG_WHEELS];
    double x;     /* metres, where the body really is, from where it began */
    double y;
    double theta; /* radians, counter-clockwise, not wrapped */
};

/* Lets LM629_MODEL_SAMPLE pass. */
void rig_sample(struct rig *rig);

/* Metres a second at the rim of the fastest wheel. */
double rig_fastest_rim(const struct rig *rig);

#endif
