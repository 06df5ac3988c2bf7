#include "command.h"

#include <string.h>

#include "angle.h"
#include "bytes.h"

/* A little more than half a turn. */
static const int32_t HEADING_LIMIT_URAD = 3200000;

static bool is_within(int32_t value, int32_t limit)
{
    return value >= -limit && value <= limit;
}

static enum answer answer_if(bool is_in_range)
{
    return is_in_range ? ANSWER_DONE : ANSWER_OUT_OF_RANGE;
}

static enum answer read_velocity(struct twist *twist, const uint8_t *payload)
{
    twist->vx_um_s = get_i32(payload);
    twist->vy_um_s = get_i32(payload + 4);
    twist->w_urad_s = get_i32(payload + 8);
    return answer_if(is_within(twist->vx_um_s, TWIST_SPEED_LIMIT_UM_S) &&
                     is_within(twist->vy_um_s, TWIST_SPEED_LIMIT_UM_S) &&
                     is_within(twist->w_urad_s, TWIST_TURN_LIMIT_URAD_S));
}

static bool read_segment(struct segment *segment, const uint8_t *at)
{
    segment->v_um_s = get_i32(at);
    segment->w_urad_s = get_i32(at + 4);
    segment->duration_us = get_u32(at + 8);
    return is_within(segment->v_um_s, TWIST_SPEED_LIMIT_UM_S) &&
           is_within(segment->w_urad_s, TWIST_TURN_LIMIT_URAD_S) &&
           segment->duration_us <= SEGMENT_LONGEST_US;
}

/* at: whether to go on, how many segments, and they. */
static bool read_segments(struct path_segments *segments, const uint8_t *at, uint8_t most)
{
    bool is_good = at[0] <= 1 && at[1] <= most && segments->path != 0;

    segments->is_onward = at[0] == 1;
    segments->count = at[1];
    for (uint8_t i = 0; is_good && i < segments->count; i++) {
        is_good = read_segment(&segments->segments[i], at + 2 + 12 * i);
    }
    return is_good;
}

static bool is_rate(uint16_t rate)
{
    return rate >= SEGMENT_LEAST_RATE && rate <= SEGMENT_HIGHEST_RATE;
}

static enum answer read_path(struct path_start *start, struct path_segments *segments,
                             const uint8_t *payload)
{
    int32_t heading_urad = get_i32(payload + 10);

    segments->path = get_u16(payload);
    start->here.x_um_q16 = (int64_t)get_i32(payload + 2) * 65536;
    start->here.y_um_q16 = (int64_t)get_i32(payload + 6) * 65536;
    start->pace_q15 = get_u16(payload + 14);
    start->limits.acceleration_mm_s2 = get_u16(payload + 16);
    start->limits.turn_acceleration_mrad_s2 = get_u16(payload + 18);
    if (!is_within(heading_urad, HEADING_LIMIT_URAD) || start->pace_q15 > SEGMENT_PACE_Q15 ||
        !is_rate(start->limits.acceleration_mm_s2) ||
        !is_rate(start->limits.turn_acceleration_mrad_s2)) {
        return ANSWER_OUT_OF_RANGE;
    }
    start->here.heading = angle_from_urad(heading_urad);
    return answer_if(read_segments(segments, payload + 20, PATH_SEGMENTS));
}

static enum answer read_more(struct path_segments *segments, const uint8_t *payload)
{
    segments->path = get_u16(payload);
    segments->first = get_u16(payload + 2);
    return answer_if(read_segments(segments, payload + 4, MORE_SEGMENTS));
}

static enum answer read_caption(char *caption, const uint8_t *payload)
{
    for (uint8_t i = 0; i < CAPTION_LENGTH; i++) {
        if (payload[i] < ' ' || payload[i] > '~') {
            return ANSWER_OUT_OF_RANGE;
        }
        caption[i] = (char)payload[i];
    }
    return ANSWER_DONE;
}

static enum answer read_settings(struct settings *settings, const uint8_t *payload)
{
    settings->wheel_radius_um = get_u32(payload);
    settings->centre_to_wheel_um = get_u32(payload + 4);
    for (uint8_t i = 0; i < BODY_FLOOR_SENSORS; i++) {
        settings->floor_mv[i] = get_u16(payload + 8 + 2 * i);
    }
    return answer_if(settings_are_good(settings));
}

static void read_joint(struct arm_joint_settings *joint, const uint8_t *at)
{
    joint->least_urad = get_i32(at);
    joint->most_urad = get_i32(at + 4);
    joint->rate_mrad_s = get_u16(at + 8);
    joint->acceleration_mrad_s2 = get_u16(at + 10);
    joint->pulse_least_us = get_u16(at + 12);
    joint->pulse_most_us = get_u16(at + 14);
    joint->mv_least = get_u16(at + 16);
    joint->mv_most = get_u16(at + 18);
}

static enum answer read_arm_settings(struct arm_settings *settings, const uint8_t *payload)
{
    read_joint(&settings->joints[0], payload);
    read_joint(&settings->joints[1], payload + 20);
    settings->open_us = get_u16(payload + 40);
    settings->closed_us = get_u16(payload + 42);
    settings->empty_mv = get_u16(payload + 44);
    settings->mv_a_kg = get_u16(payload + 46);
    return answer_if(arm_settings_are_good(settings));
}

static enum answer read_arm_goal(struct arm_goal *goal, const uint8_t *payload)
{
    goal->urad[0] = get_i32(payload);
    goal->urad[1] = get_i32(payload + 4);
    goal->is_hand_closed = payload[8] == 1;
    goal->is_onward = payload[9] == 1;
    return answer_if(payload[8] <= 1 && payload[9] <= 1);
}

enum answer command_read(struct command *command, const uint8_t frame[FRAME_LENGTH])
{
    const uint8_t *payload = frame + FRAME_PAYLOAD;

    memset(command, 0, sizeof *command);
    command->sequence = frame[FRAME_SEQUENCE];
    command->kind = (enum command_kind)frame[FRAME_KIND];
    switch (frame[FRAME_KIND]) {
    case COMMAND_POLL:
        return ANSWER_DONE;
    case COMMAND_VELOCITY:
        return read_velocity(&command->as.velocity, payload);
    case COMMAND_PATH:
        return read_path(&command->as.path.start, &command->as.path.more, payload);
    case COMMAND_SEGMENTS:
        return read_more(&command->as.path.more, payload);
    case COMMAND_CLEAR:
        command->as.clear.reasons = get_u16(payload);
        command->as.clear.by_person = payload[2] == 1;
        return answer_if(payload[2] <= 1);
    case COMMAND_CAPTION:
        return read_caption(command->as.caption, payload);
    case COMMAND_SETTINGS:
        return read_settings(&command->as.settings, payload);
    case COMMAND_ARM_SETTINGS:
        return read_arm_settings(&command->as.arm_settings, payload);
    case COMMAND_ARM_MOVE:
        return read_arm_goal(&command->as.arm_goal, payload);
    case COMMAND_ARM_POLL:
        return ANSWER_DONE;
    default:
        return ANSWER_UNKNOWN_KIND;
    }
}
