#include "robot.h"

#include <string.h>

#include "angle.h"
#include "drive.h"
#include "slew.h"

enum {
    VELOCITY_LIFE_MS = 200,
    HOT_CELSIUS = 85,
    SWITCH_PERIOD_MS = 16, /* contacts have settled after less; a power of two */
    SWITCH_DISPLAY = 1,
};

/* A path that begins farther away, 0.5 m in x or y, is none of this robot's. */
static const int64_t NEAR_UM_Q16 = INT64_C(500000) << 16;

static const struct twist STANDSTILL = {0, 0, 0};

static bool is_stopped(const struct robot *robot)
{
    return robot->stop.reasons != 0;
}

static void brake(struct robot *robot)
{
    robot->velocity_command.is_active = false;
    robot->motion.twist = STANDSTILL;
    memset(&robot->motion.rates, 0, sizeof robot->motion.rates);
    segment_runner_stop(&robot->segment_runner);
    arm_halt(&robot->arm);
    stall_begin(&robot->stall, robot->odometry.counts);
    stop_set_cause(&robot->stop, STOP_DRIVE, !drive_stop());
}

void robot_begin(struct robot *robot, enum stop_reason reason, uint16_t power_cycle,
                 const struct settings *settings, const struct arm_settings *arm_settings)
{
    static const int32_t zero[BODY_WHEELS] = {0, 0, 0};

    memset(robot, 0, sizeof *robot);
    stop_begin(&robot->stop, reason);
    robot->settings = *settings;
    robot->wheel_scale = wheel_scale_of(settings);
    arm_begin(&robot->arm, arm_settings);
    odometry_begin(&robot->odometry, zero, settings);
    segment_runner_begin(&robot->segment_runner);
    stall_begin(&robot->stall, zero);
    battery_begin(&robot->battery);
    range_begin(&robot->range);
    robot->power_cycle = power_cycle;
    memset(robot->caption, ' ', CAPTION_LENGTH);
    stop_set_cause(&robot->stop, STOP_DRIVE, !drive_begin());
}

static enum answer set_velocity(struct robot *robot, const struct twist *velocity)
{
    if (is_stopped(robot)) {
        return ANSWER_STOPPED;
    }
    if (arm_is_moving(&robot->arm) && memcmp(velocity, &STANDSTILL, sizeof STANDSTILL) != 0) {
        return ANSWER_MOVES;
    }
    segment_runner_stop(&robot->segment_runner);
    robot->velocity_command.is_active = true;
    robot->velocity_command.twist = *velocity;
    robot->velocity_command.set_ms = robot->now_ms;
    return ANSWER_DONE;
}

static bool is_near(const struct robot *robot, const struct pose *place)
{
    int64_t far_x = place->x_um_q16 - robot->odometry.pose.x_um_q16;
    int64_t far_y = place->y_um_q16 - robot->odometry.pose.y_um_q16;

    return far_x >= -NEAR_UM_Q16 && far_x <= NEAR_UM_Q16 && far_y >= -NEAR_UM_Q16 &&
           far_y <= NEAR_UM_Q16;
}

static enum answer add_segments(struct robot *robot, const struct path_segments *more)
{
    struct segment_runner *runner = &robot->segment_runner;
    uint16_t known = (uint16_t)(runner->queue.driven + runner->queue.count);
    uint16_t skipped = (uint16_t)(known - more->first);
    uint8_t count;

    if (skipped > UINT16_MAX / 2) {
        return ANSWER_NOT_ON_PATH; /* some before these have not come */
    }
    runner->is_onward = more->is_onward;
    if (skipped >= more->count) {
        return ANSWER_DONE;
    }
    count = (uint8_t)(more->count - skipped);
    return segment_queue_add(&runner->queue, more->segments + skipped, count) == count
               ? ANSWER_DONE
               : ANSWER_QUEUE_FULL;
}

/* A path that was begun once is not begun again, whatever became of it. */
static enum answer begin_path(struct robot *robot, const struct path_start *start,
                              const struct path_segments *first)
{
    if (is_stopped(robot)) {
        return ANSWER_STOPPED;
    }
    if (first->path == robot->path) {
        return robot->segment_runner.is_active ? ANSWER_DONE : ANSWER_NOT_ON_PATH;
    }
    if (arm_is_moving(&robot->arm)) {
        return ANSWER_MOVES;
    }
    if (!is_near(robot, &start->here)) {
        return ANSWER_OUT_OF_RANGE;
    }
    robot->path = first->path;
    robot->velocity_command.is_active = false;
    segment_runner_start(&robot->segment_runner, &start->here, start->pace_q15, &start->limits);
    return add_segments(robot, first);
}

static enum answer go_on(struct robot *robot, const struct path_segments *more)
{
    if (is_stopped(robot)) {
        return ANSWER_STOPPED;
    }
    if (!robot->segment_runner.is_active || more->path != robot->path) {
        return ANSWER_NOT_ON_PATH;
    }
    if (arm_is_moving(&robot->arm)) {
        return ANSWER_MOVES;
    }
    return add_segments(robot, more);
}

static bool is_moving(const struct robot *robot)
{
    enum robot_state state = robot_state(robot);

    return state == ROBOT_DRIVING || state == ROBOT_PATH_DRIVING || robot->motion.has_turned;
}

/* A robot that moves keeps its wheels. */
static enum answer set_settings(struct robot *robot, const struct settings *settings)
{
    if (settings_are_same(settings, &robot->settings)) {
        return ANSWER_DONE;
    }
    if (is_moving(robot)) {
        return ANSWER_MOVES;
    }
    robot->settings = *settings;
    robot->wheel_scale = wheel_scale_of(settings);
    odometry_set_wheels(&robot->odometry, settings);
    segment_runner_stop(&robot->segment_runner); /* its reference is of the wheels before */
    return ANSWER_DONE;
}

static enum answer set_arm(struct robot *robot, const struct arm_settings *settings)
{
    if (arm_settings_are_same(settings, &robot->arm.settings)) {
        return ANSWER_DONE;
    }
    if (arm_is_moving(&robot->arm)) {
        return ANSWER_MOVES;
    }
    arm_begin(&robot->arm, settings);
    return ANSWER_DONE;
}

/* A robot that drives keeps its arm still; the program has no time for both at 8 MHz. */
static bool may_move_arm(const struct robot *robot)
{
    enum robot_state state = robot_state(robot);

    return state == ROBOT_STANDING || state == ROBOT_PATH_STANDING;
}

static enum answer move_arm(struct robot *robot, const struct arm_goal *goal)
{
    if (is_stopped(robot)) {
        return ANSWER_STOPPED;
    }
    return may_move_arm(robot) ? arm_move(&robot->arm, goal, robot->now_ms) : ANSWER_MOVES;
}

static enum answer execute(struct robot *robot, const struct command *command)
{
    switch (command->kind) {
    case COMMAND_VELOCITY:
        return set_velocity(robot, &command->as.velocity);
    case COMMAND_PATH:
        return begin_path(robot, &command->as.path.start, &command->as.path.more);
    case COMMAND_SEGMENTS:
        return go_on(robot, &command->as.path.more);
    case COMMAND_CLEAR:
        return stop_clear(&robot->stop, command->as.clear.reasons, command->as.clear.by_person)
                   ? ANSWER_DONE
                   : ANSWER_NOT_CLEARED;
    case COMMAND_CAPTION:
        memcpy(robot->caption, command->as.caption, CAPTION_LENGTH);
        return ANSWER_DONE;
    case COMMAND_SETTINGS:
        return set_settings(robot, &command->as.settings);
    case COMMAND_ARM_SETTINGS:
        return set_arm(robot, &command->as.arm_settings);
    case COMMAND_ARM_MOVE:
        return move_arm(robot, &command->as.arm_goal);
    case COMMAND_POLL:
    case COMMAND_ARM_POLL:
        break;
    }
    return ANSWER_DONE;
}

void robot_handle_frame(struct robot *robot, const uint8_t frame[FRAME_LENGTH])
{
    struct command command;
    enum answer answer = command_read(&command, frame);
    struct conversation *conversation = &robot->conversation;
    bool is_again =
        conversation->answer != ANSWER_NONE && command.sequence == conversation->sequence;

    conversation->last_frame_ms = robot->now_ms;
    stop_set_cause(&robot->stop, STOP_LINK, false);
    conversation->is_of_arm =
        command.kind == COMMAND_ARM_MOVE || command.kind == COMMAND_ARM_POLL;
    if ((command.kind == COMMAND_POLL || command.kind == COMMAND_ARM_POLL) &&
        answer == ANSWER_DONE) {
        return;
    }
    if (is_again) {
        return;
    }
    conversation->sequence = command.sequence;
    conversation->answer = answer == ANSWER_DONE ? execute(robot, &command) : answer;
}

static uint8_t missing_floor(const struct robot *robot, const struct robot_inputs *inputs)
{
    uint8_t missing = 0;

    for (uint8_t i = 0; i < BODY_FLOOR_SENSORS; i++) {
        if (inputs->floor_mv[i] < robot->settings.floor_mv[i]) {
            missing = (uint8_t)(missing | 1U << i);
        }
    }
    return missing;
}

/* Pressed and released, switch 2 changes what the display shows. */
static void update_switches(struct robot *robot, uint8_t pressed)
{
    uint8_t released = (uint8_t)(robot->pressed_switches & ~pressed);

    if ((released & SWITCH_DISPLAY) != 0) {
        robot->shows_measurements = !robot->shows_measurements;
    }
    robot->pressed_switches = pressed;
}

static void update_inputs(struct robot *robot, const struct robot_inputs *inputs)
{
    struct stop *stop = &robot->stop;

    robot->missing_floor = missing_floor(robot, inputs);
    robot->temperature = inputs->temperature;
    if ((uint8_t)robot->now_ms % SWITCH_PERIOD_MS == 0) {
        update_switches(robot, inputs->pressed_switches);
    }
    battery_update(&robot->battery, inputs->battery_mv, 1);
    range_elapse(&robot->range, 1);
    stop_set_cause(stop, STOP_LINK,
                   robot->now_ms - robot->conversation.last_frame_ms >= STOP_LINK_MS);
    stop_set_cause(stop, STOP_SWITCH, inputs->is_stop_pressed);
    stop_set_cause(stop, STOP_EDGE, robot->missing_floor != 0);
    stop_set_cause(stop, STOP_HEAT, inputs->is_hot || inputs->temperature >= HOT_CELSIUS);
    stop_set_cause(stop, STOP_BATTERY, battery_is_low(&robot->battery));
}

void robot_update(struct robot *robot, const struct robot_inputs *inputs, uint32_t now_ms)
{
    bool was_stopped = is_stopped(robot);

    robot->now_ms = now_ms;
    update_inputs(robot, inputs);
    if (!was_stopped && is_stopped(robot)) {
        brake(robot);
    } else if (is_stopped(robot)) {
        stop_set_cause(&robot->stop, STOP_DRIVE, !drive_stop());
    }
}

/* Returns whether a wheel has turned. */
static bool read_odometry(struct robot *robot)
{
    int32_t counts[BODY_WHEELS];
    bool has_turned;

    if (!drive_read_counts(counts)) {
        stop_set_cause(&robot->stop, STOP_DRIVE, true);
        return false;
    }
    has_turned = memcmp(robot->odometry.counts, counts, sizeof counts) != 0;
    odometry_update(&robot->odometry, counts);
    return has_turned;
}

static struct twist wanted_twist(struct robot *robot)
{
    if (robot->segment_runner.is_active) {
        return segment_runner_tick(&robot->segment_runner, &robot->odometry.pose, DRIVE_PERIOD_MS);
    }
    if (!robot->velocity_command.is_active) {
        return STANDSTILL;
    }
    if (robot->now_ms - robot->velocity_command.set_ms >= VELOCITY_LIFE_MS) {
        robot->velocity_command.twist = STANDSTILL;
    }
    return robot->velocity_command.twist;
}

static void turn_wheels(struct robot *robot)
{
    struct twist wanted = wanted_twist(robot);

    if (stall_update(&robot->stall, &robot->motion.rates, robot->odometry.counts,
                     DRIVE_PERIOD_MS)) {
        stop_set_cause(&robot->stop, STOP_STALL, true);
        stop_set_cause(&robot->stop, STOP_STALL, false);
        brake(robot);
        return;
    }
    slew_towards(&robot->motion.twist, &wanted, DRIVE_PERIOD_MS);
    wheel_rates_from_twist(&robot->wheel_scale, &robot->motion.twist, &robot->motion.rates);
    wheel_rates_limit(&robot->motion.rates);
    if (!drive_turn(&robot->motion.rates)) {
        stop_set_cause(&robot->stop, STOP_DRIVE, true);
        brake(robot);
    }
}

/* A wheel that springs back seems to be stopped in one period: so all must be in two. */
void robot_control_wheels(struct robot *robot)
{
    bool had_turned = robot->motion.has_turned;

    robot->motion.has_turned = read_odometry(robot);
    if (!is_stopped(robot)) {
        turn_wheels(robot);
    } else if (!had_turned && !robot->motion.has_turned) {
        stop_set_cause(&robot->stop, STOP_DRIVE, !drive_rest());
    }
    arm_tick(&robot->arm, robot->now_ms, may_move_arm(robot));
}

enum robot_state robot_state(const struct robot *robot)
{
    if (is_stopped(robot)) {
        return ROBOT_STOPPED;
    }
    if (robot->segment_runner.is_active) {
        return robot->segment_runner.is_settled ? ROBOT_PATH_STANDING : ROBOT_PATH_DRIVING;
    }
    return memcmp(&robot->motion.twist, &STANDSTILL, sizeof STANDSTILL) == 0 ? ROBOT_STANDING
                                                                             : ROBOT_DRIVING;
}

/* Not 0 while it moves. */
static uint8_t pace_of_255(uint16_t pace_q15)
{
    return (uint8_t)((pace_q15 * UINT32_C(255) + 32767) >> 15);
}

void robot_fill_status(const struct robot *robot, struct status *status)
{
    const struct pose *pose = &robot->odometry.pose;

    memset(status, 0, sizeof *status);
    status->sequence = robot->conversation.sequence;
    status->answer = robot->conversation.answer;
    status->state = robot_state(robot);
    status->stop_reasons = robot->stop.reasons;
    status->power_cycle = robot->power_cycle;
    status->stamp_ms = robot->now_ms;
    memcpy(status->counts, robot->odometry.counts, sizeof status->counts);
    status->x_um = pose_um(pose->x_um_q16);
    status->y_um = pose_um(pose->y_um_q16);
    status->heading_urad = angle_urad(pose->heading);
    memcpy(status->range_mm, robot->range.mm, sizeof status->range_mm);
    status->battery_mv = battery_mv(&robot->battery);
    status->missing_floor = robot->missing_floor;
    status->pressed_switches = robot->pressed_switches;
    status->temperature = robot->temperature;
    status->queue_free = (uint8_t)(SEGMENT_QUEUE_LENGTH - robot->segment_runner.queue.count);
    status->segments_driven = robot->segment_runner.queue.driven;
    status->path = robot->path;
    status->pace = pace_of_255(robot->segment_runner.queue.pace_q15);
    status->covered_us = robot->segment_runner.queue.covered_us;
}
