/* What the robot reports: the status frame of docs/spi-frame.md as a value. */
#ifndef STATUS_H
#define STATUS_H

#include <stdint.h>

#include "arm.h"
#include "body.h"
#include "command.h"
#include "frame.h"
#include "range.h"

enum { STATUS_KIND = 0x80, ARM_STATUS_KIND = 0x81 };

enum robot_state {
    ROBOT_STOPPED = 0,
    ROBOT_STANDING = 1,
    ROBOT_DRIVING = 2,
    ROBOT_PATH_STANDING = 3,
    ROBOT_PATH_DRIVING = 4,
};

struct status {
    uint8_t sequence;
    enum answer answer;
    enum robot_state state;
    uint16_t stop_reasons;
    uint16_t power_cycle;
    uint32_t stamp_ms;
    int32_t counts[BODY_WHEELS];
    int32_t x_um;
    int32_t y_um;
    int32_t heading_urad;
    uint16_t range_mm[RANGE_SENSORS];
    uint16_t battery_mv;
    uint8_t missing_floor;
    uint8_t pressed_switches; /* bit 0 to 2: switches 2 to 4 */
    int8_t temperature;       /* degrees Celsius */
    uint8_t queue_free;
    uint16_t segments_driven;
    uint16_t path;
    uint8_t pace; /* 255 as planned */
    uint32_t covered_us;
    uint16_t bad_frames;
    uint16_t lost_bytes;
};

void status_write(const struct status *status, uint8_t frame[FRAME_LENGTH]);

/* That of the arm: of the status, what both have in common. */
void status_write_arm(const struct status *status, const struct arm_report *arm,
                      uint8_t frame[FRAME_LENGTH]);

#endif
