#include "status.h"

#include <string.h>

#include "bytes.h"

/* What is at the same place in both. */
static void write_common(const struct status *status, uint8_t frame[FRAME_LENGTH])
{
    memset(frame, 0, FRAME_LENGTH);
    frame[4] = (uint8_t)status->answer;
    frame[5] = (uint8_t)status->state;
    put_u16(frame + 6, status->stop_reasons);
    put_u16(frame + 8, status->power_cycle);
    put_u32(frame + 10, status->stamp_ms);
    put_u16(frame + 50, status->bad_frames);
    put_u16(frame + 52, status->lost_bytes);
}

void status_write_arm(const struct status *status, const struct arm_report *arm,
                      uint8_t frame[FRAME_LENGTH])
{
    write_common(status, frame);
    frame[14] = (uint8_t)arm->state;
    frame[15] = arm->is_hand_closed;
    for (uint8_t i = 0; i < ARM_JOINTS; i++) {
        put_i32(frame + 16 + 4 * i, arm->angle_urad[i]);
        put_i32(frame + 24 + 4 * i, arm->goal_urad[i]);
    }
    put_u16(frame + 32, arm->load_g);
    frame[34] = arm->progress;
    frame_seal(frame, ARM_STATUS_KIND, status->sequence);
}

void status_write(const struct status *status, uint8_t frame[FRAME_LENGTH])
{
    write_common(status, frame);
    for (uint8_t i = 0; i < BODY_WHEELS; i++) {
        put_i32(frame + 14 + 4 * i, status->counts[i]);
    }
    put_i32(frame + 26, status->x_um);
    put_i32(frame + 30, status->y_um);
    put_i32(frame + 34, status->heading_urad);
    for (uint8_t i = 0; i < RANGE_SENSORS; i++) {
        put_u16(frame + 38 + 2 * i, status->range_mm[i]);
    }
    put_u16(frame + 44, status->battery_mv);
    frame[46] = (uint8_t)(status->missing_floor | status->pressed_switches << BODY_FLOOR_SENSORS);
    frame[47] = status->queue_free;
    put_u16(frame + 48, status->segments_driven);
    put_u16(frame + 54, status->path);
    frame[56] = status->pace;
    frame[57] = (uint8_t)status->temperature;
    put_u32(frame + 58, status->covered_us);
    frame_seal(frame, STATUS_KIND, status->sequence);
}
