#include "robot.h"

#include <string.h>

#include "angle.h"
#include "drive.h"
#include "slew.h"

enum { VELOCITY_LIFE_MS = 200 };

static const struct twist STILL = {0, 0, 0};

static bool is_stopped(const struct robot *robot)
{
    return robot->stop.reasons != 0;
}

static void brake(struct robot *robot)
{
    robot->is_by_velocity = false;
    robot->twist = STILL;
    memset(&robot->rates, 0, sizeof robot->rates);
    follower_place(&robot->follower, &robot->odometer.pose);
    stall_begin(&robot->stall, robot->odometer.counts);
    stop_cause(&robot->stop, STOP_DRIVE, !drive_stop());
}

void robot_begin(struct robot *robot, enum stop_reason reason, uint16_t power_cycle)
{
    static const int32_t zero[BODY_WHEELS] = {0, 0, 0};

    memset(robot, 0, sizeof *robot);
    stop_begin(&robot->stop, reason);
    odometer_begin(&robot->odometer, zero);
    follower_begin(&robot->follower);
    stall_begin(&robot->stall, zero);
    battery_begin(&robot->battery);
    range_begin(&robot->range);
    robot->power_cycle = power_cycle;
    memset(robot->caption, ' ', CAPTION_LENGTH);
    stop_cause(&robot->stop, STOP_DRIVE, !drive_begin());
}

static enum answer drive_at(struct robot *robot, const struct twist *velocity)
{
    if (is_stopped(robot)) {
        return ANSWER_STOPPED;
    }
    follower_place(&robot->follower, &robot->odometer.pose);
    robot->is_by_velocity = true;
    robot->velocity = *velocity;
    robot->velocity_ms = robot->now_ms;
    return ANSWER_DONE;
}

static enum answer queue_segment(struct robot *robot, const struct segment *segment)
{
    if (is_stopped(robot)) {
        return ANSWER_STOPPED;
    }
    if (robot->is_by_velocity || robot->follower.is_settled) {
        follower_place(&robot->follower, &robot->odometer.pose);
    }
    robot->is_by_velocity = false;
    return follower_add(&robot->follower, segment) ? ANSWER_DONE : ANSWER_QUEUE_FULL;
}

static enum answer halt(struct robot *robot)
{
    robot->velocity = STILL;
    follower_halt(&robot->follower);
    return ANSWER_DONE;
}

static enum answer obey(struct robot *robot, const struct command *command)
{
    switch (command->kind) {
    case COMMAND_VELOCITY:
        return drive_at(robot, &command->as.velocity);
    case COMMAND_SEGMENT:
        return queue_segment(robot, &command->as.segment);
    case COMMAND_HALT:
        return halt(robot);
    case COMMAND_CLEAR:
        return stop_clear(&robot->stop, command->as.clear.reasons, command->as.clear.by_person)
                   ? ANSWER_DONE
                   : ANSWER_NOT_CLEARED;
    case COMMAND_CAPTION:
        memcpy(robot->caption, command->as.caption, CAPTION_LENGTH);
        return ANSWER_DONE;
    case COMMAND_POLL:
        break;
    }
    return ANSWER_DONE;
}

void robot_hear(struct robot *robot, const uint8_t frame[FRAME_LENGTH])
{
    struct command command;
    enum answer answer = command_read(&command, frame);
    bool is_again = robot->answer != ANSWER_NONE && command.sequence == robot->sequence;

    robot->heard_ms = robot->now_ms;
    stop_cause(&robot->stop, STOP_LINK, false);
    if (command.kind == COMMAND_POLL && answer == ANSWER_DONE) {
        return;
    }
    if (is_again) {
        return;
    }
    robot->sequence = command.sequence;
    robot->answer = answer == ANSWER_DONE ? obey(robot, &command) : answer;
}

static void feel(struct robot *robot, const struct robot_inputs *inputs)
{
    struct stop *stop = &robot->stop;

    robot->floor_gone = inputs->floor_gone;
    battery_measure(&robot->battery, inputs->battery_mv, 1);
    range_wait(&robot->range, 1);
    stop_cause(stop, STOP_LINK, robot->now_ms - robot->heard_ms >= STOP_LINK_MS);
    stop_cause(stop, STOP_SWITCH, inputs->is_stop_pressed);
    stop_cause(stop, STOP_EDGE, inputs->floor_gone != 0);
    stop_cause(stop, STOP_HEAT, inputs->is_hot);
    stop_cause(stop, STOP_BATTERY, battery_is_low(&robot->battery));
}

void robot_watch(struct robot *robot, const struct robot_inputs *inputs, uint32_t now_ms)
{
    bool was_stopped = is_stopped(robot);

    robot->now_ms = now_ms;
    feel(robot, inputs);
    if (!was_stopped && is_stopped(robot)) {
        brake(robot);
    } else if (is_stopped(robot)) {
        stop_cause(&robot->stop, STOP_DRIVE, !drive_stop());
    }
}

/* Returns whether a wheel has turned. */
static bool read_odometer(struct robot *robot)
{
    int32_t counts[BODY_WHEELS];
    bool has_turned;

    if (!drive_read_counts(counts)) {
        stop_cause(&robot->stop, STOP_DRIVE, true);
        return false;
    }
    has_turned = memcmp(robot->odometer.counts, counts, sizeof counts) != 0;
    odometer_update(&robot->odometer, counts);
    return has_turned;
}

static struct twist wanted_twist(struct robot *robot)
{
    if (!robot->is_by_velocity) {
        return follower_tick(&robot->follower, &robot->odometer.pose, DRIVE_PERIOD_MS);
    }
    if (robot->now_ms - robot->velocity_ms >= VELOCITY_LIFE_MS) {
        robot->velocity = STILL;
    }
    return robot->velocity;
}

static void turn_wheels(struct robot *robot)
{
    struct twist wanted = wanted_twist(robot);

    if (stall_watch(&robot->stall, &robot->rates, robot->odometer.counts, DRIVE_PERIOD_MS)) {
        stop_cause(&robot->stop, STOP_STALL, true);
        stop_cause(&robot->stop, STOP_STALL, false);
        brake(robot);
        return;
    }
    slew_towards(&robot->twist, &wanted, DRIVE_PERIOD_MS);
    wheel_rates_of(&robot->twist, &robot->rates);
    wheel_rates_limit(&robot->rates);
    if (!drive_turn(&robot->rates)) {
        stop_cause(&robot->stop, STOP_DRIVE, true);
        brake(robot);
    }
}

/* Wheels that come back have not turned in one period: so they must not in two. */
void robot_drive(struct robot *robot)
{
    bool had_turned = robot->has_turned;

    robot->has_turned = read_odometer(robot);
    if (!is_stopped(robot)) {
        turn_wheels(robot);
    } else if (!had_turned && !robot->has_turned) {
        stop_cause(&robot->stop, STOP_DRIVE, !drive_rest());
    }
}

enum robot_state robot_state(const struct robot *robot)
{
    if (is_stopped(robot)) {
        return ROBOT_STOPPED;
    }
    if (robot->is_by_velocity) {
        return memcmp(&robot->twist, &STILL, sizeof STILL) == 0 ? ROBOT_STANDS : ROBOT_DRIVES;
    }
    return robot->follower.is_settled ? ROBOT_STANDS : ROBOT_DRIVES;
}

void robot_tell(const struct robot *robot, struct status *status)
{
    const struct pose *pose = &robot->odometer.pose;

    memset(status, 0, sizeof *status);
    status->sequence = robot->sequence;
    status->answer = robot->answer;
    status->state = robot_state(robot);
    status->stop_reasons = robot->stop.reasons;
    status->power_cycle = robot->power_cycle;
    status->stamp_ms = robot->now_ms;
    memcpy(status->counts, robot->odometer.counts, sizeof status->counts);
    status->x_um = pose_um(pose->x_um_q16);
    status->y_um = pose_um(pose->y_um_q16);
    status->heading_urad = angle_urad(pose->heading);
    memcpy(status->range_mm, robot->range.mm, sizeof status->range_mm);
    status->battery_mv = battery_mv(&robot->battery);
    status->floor = robot->floor_gone;
    status->queue_free = (uint8_t)(SEGMENT_QUEUE_LENGTH - robot->follower.queue.count);
    status->segments_driven = robot->follower.queue.driven;
}
