#include "rig.h"

#include <math.h>

static const double WHEEL_RADIUS = 0.04;
static const double CENTRE_TO_WHEEL = 0.10;
static const double COUNTS_A_TURN = 2808;

static double metres(double counts)
{
    return counts * 2 * M_PI * WHEEL_RADIUS / COUNTS_A_TURN;
}

/* vx = (v1 - v3)/sqrt(3),  vy = (2 v2 - v1 - v3)/3,  w = (v1 + v2 + v3)/(3 R) */
static void carry(struct rig *rig, const double m[RIG_WHEELS])
{
    double forward = (m[0] - m[2]) / sqrt(3);
    double left = (2 * m[1] - m[0] - m[2]) / 3;
    double turn = (m[0] + m[1] + m[2]) / (3 * CENTRE_TO_WHEEL);
    double middle = rig->theta + turn / 2;

    rig->x += forward * cos(middle) - left * sin(middle);
    rig->y += forward * sin(middle) + left * cos(middle);
    rig->theta += turn;
}

void rig_turn(struct rig *rig, const double duties[RIG_WHEELS], double seconds)
{
    double moved[RIG_WHEELS];

    for (int i = 0; i < RIG_WHEELS; i++) {
        double before = rig->motors[i].angle;

        motor_turn(&rig->motors[i], duties[i], seconds);
        moved[i] = metres(rig->motors[i].angle - before) * (1 + rig->motors[i].larger);
    }
    carry(rig, moved);
}

double rig_fastest_rim(const struct rig *rig)
{
    double fastest = 0;

    for (int i = 0; i < RIG_WHEELS; i++) {
        fastest = fmax(fastest, fabs(metres(rig->motors[i].rate)));
    }
    return fastest;
}
