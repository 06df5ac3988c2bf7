/* The whole robot: its commands, its sensors and its wheels. */
#ifndef ROBOT_H
#define ROBOT_H

#include <stdbool.h>
#include <stdint.h>

#include "arm.h"
#include "battery.h"
#include "command.h"
#include "odometry.h"
#include "range.h"
#include "segment_runner.h"
#include "settings.h"
#include "stall.h"
#include "status.h"
#include "stop.h"
#include "wheel.h"

/* What the sensors measure now. */
struct robot_inputs {
    uint16_t floor_mv[BODY_FLOOR_SENSORS];
    bool is_hot;               /* a motor driver says so */
    int8_t temperature;        /* of the motor drivers, degrees Celsius */
    bool is_stop_pressed;
    uint8_t pressed_switches; /* bit 0 to 2: switches 2 to 4 */
    uint16_t battery_mv;
};

/* The velocity that was commanded last. */
struct velocity_command {
    struct twist twist;
    uint32_t set_ms;
    bool is_active; /* else the robot drives by segments */
};

/* What the wheels do. */
struct motion {
    struct twist twist;
    struct wheel_rates rates;
    bool has_turned; /* a wheel, in the last period */
};

/* The exchange of frames with the daemon. */
struct conversation {
    uint32_t last_frame_ms; /* the last good one */
    uint8_t sequence;
    enum answer answer;
    bool is_of_arm; /* what was asked last: the arm's status answers it */
};

struct robot {
    struct stop stop;
    struct odometry odometry;
    struct segment_runner segment_runner;
    struct stall stall;
    struct battery battery;
    struct range range;
    struct velocity_command velocity_command;
    struct motion motion;
    uint16_t path; /* the number of the last one that was begun; 0 before the first */
    struct settings settings;
    struct arm arm;
    struct wheel_scale wheel_scale;
    uint8_t missing_floor; /* bit 0 to 4: floor sensors that see no floor */
    int8_t temperature;
    uint8_t pressed_switches;
    bool shows_measurements; /* on the display */
    uint32_t now_ms;
    struct conversation conversation;
    uint16_t power_cycle;
    char caption[CAPTION_LENGTH];
};

void robot_begin(struct robot *robot, enum stop_reason reason, uint16_t power_cycle,
                 const struct settings *settings, const struct arm_settings *arm_settings);

/* Executes the command of a good frame. */
void robot_handle_frame(struct robot *robot, const uint8_t frame[FRAME_LENGTH]);

/* Every millisecond: stops the wheels at once when there is a cause. */
void robot_update(struct robot *robot, const struct robot_inputs *inputs, uint32_t now_ms);

/* Every DRIVE_PERIOD_MS: odometry, wheels and arm. */
void robot_control_wheels(struct robot *robot);

enum robot_state robot_state(const struct robot *robot);

/* All but the counts of bad frames and lost bytes, which others keep. */
void robot_fill_status(const struct robot *robot, struct status *status);

#endif
