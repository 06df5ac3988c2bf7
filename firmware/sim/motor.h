/* A 12 V motor with its 1:27 gear, wheel and encoder. */
#ifndef MOTOR_H
#define MOTOR_H

#include <stdbool.h>

struct motor {
    double rate;  /* counts a second */
    double angle; /* counts */
    double load;  /* that it moves beside the robot, as a share of the robot's own mass */
    double larger; /* than its encoder is told, as a share of the wheel's size */
    bool is_blocked;
    bool is_pushed; /* from outside, at the rated speed */
};

/* duty: -1 to 1, held for so many seconds; they must be few against the motor's 0.04 s. */
void motor_turn(struct motor *motor, double duty, double seconds);

#endif
