/* The whole robot: what it was told, what it feels, and what its wheels do. */
#ifndef ROBOT_H
#define ROBOT_H

#include <stdbool.h>
#include <stdint.h>

#include "battery.h"
#include "command.h"
#include "follower.h"
#include "odometer.h"
#include "range.h"
#include "stall.h"
#include "status.h"
#include "stop.h"
#include "wheel.h"

/* What the robot feels now. */
struct robot_inputs {
    uint8_t floor_gone; /* bit 0 to 4: floor sensors that see no floor */
    bool is_hot;
    bool is_stop_pressed;
    uint16_t battery_mv;
};

struct robot {
    struct stop stop;
    struct odometer odometer;
    struct follower follower;
    struct stall stall;
    struct battery battery;
    struct range range;
    struct twist velocity; /* that is wanted */
    uint32_t velocity_ms;  /* when it was wanted */
    bool is_by_velocity;   /* else by segments */
    struct twist twist;    /* that is driven */
    struct wheel_rates rates;
    bool has_turned; /* a wheel, in the last period */
    uint8_t floor_gone;
    uint32_t now_ms;
    uint32_t heard_ms; /* the last good frame */
    uint16_t power_cycle;
    uint8_t sequence;
    enum answer answer;
    char caption[CAPTION_LENGTH];
};

void robot_begin(struct robot *robot, enum stop_reason reason, uint16_t power_cycle);

/* A good frame came. */
void robot_hear(struct robot *robot, const uint8_t frame[FRAME_LENGTH]);

/* Every millisecond: stops the wheels at once when there is a cause. */
void robot_watch(struct robot *robot, const struct robot_inputs *inputs, uint32_t now_ms);

/* Every DRIVE_PERIOD_MS: odometry and wheels. */
void robot_drive(struct robot *robot);

enum robot_state robot_state(const struct robot *robot);

/* All but the counts of bad frames and lost bytes, which others keep. */
void robot_tell(const struct robot *robot, struct status *status);

#endif
