#include "command.h"

#include <string.h>

#include "bytes.h"

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

static enum answer read_segment(struct segment *segment, const uint8_t *payload)
{
    segment->v_um_s = get_i32(payload);
    segment->w_urad_s = get_i32(payload + 4);
    segment->duration_ms = get_u32(payload + 8);
    return answer_if(is_within(segment->v_um_s, TWIST_SPEED_LIMIT_UM_S) &&
                     is_within(segment->w_urad_s, TWIST_TURN_LIMIT_URAD_S) &&
                     segment->duration_ms >= 1 && segment->duration_ms <= SEGMENT_LONGEST_MS);
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

enum answer command_read(struct command *command, const uint8_t frame[FRAME_LENGTH])
{
    const uint8_t *payload = frame + FRAME_PAYLOAD;

    memset(command, 0, sizeof *command);
    command->sequence = frame[FRAME_SEQUENCE];
    command->kind = (enum command_kind)frame[FRAME_KIND];
    switch (frame[FRAME_KIND]) {
    case COMMAND_POLL:
    case COMMAND_HALT:
        return ANSWER_DONE;
    case COMMAND_VELOCITY:
        return read_velocity(&command->as.velocity, payload);
    case COMMAND_SEGMENT:
        return read_segment(&command->as.segment, payload);
    case COMMAND_CLEAR:
        command->as.clear.reasons = get_u16(payload);
        command->as.clear.by_person = payload[2] == 1;
        return answer_if(payload[2] <= 1);
    case COMMAND_CAPTION:
        return read_caption(command->as.caption, payload);
    default:
        return ANSWER_UNKNOWN_KIND;
    }
}
