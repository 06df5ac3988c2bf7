#include "motor.h"

#include <math.h>

/* 220 turns a minute without friction, and how fast it gets there: the lag of the daemon's own model. */
static const double FASTEST_RATE = 220 / 60.0 * 2808;
static const double LAG_SECONDS = 0.04;

/* The share of the full voltage that friction takes. */
static const double FRICTION = 0.02;

void motor_turn(struct motor *motor, double duty, double seconds)
{
    double friction = FRICTION * FASTEST_RATE * tanh(motor->rate / 50);
    double lag = LAG_SECONDS * (1 + motor->load);

    motor->rate += (duty * FASTEST_RATE - friction - motor->rate) * seconds / lag;
    if (motor->is_blocked) {
        motor->rate = 0;
    } else if (motor->is_pushed) {
        motor->rate = FASTEST_RATE;
    }
    motor->angle += motor->rate * seconds;
}
