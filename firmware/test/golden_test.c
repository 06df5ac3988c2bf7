/* The golden frames, which the daemon's tests read too. */
#include <stdlib.h>
#include <string.h>

#include "angle.h"
#include "check.h"
#include "command.h"
#include "status.h"
#include "tests.h"

struct golden {
    char text[960];
    uint8_t frame[FRAME_LENGTH];
};

static int64_t value(const struct golden *golden, const char *key)
{
    char pattern[32];
    const char *at;

    snprintf(pattern, sizeof pattern, " %s=", key);
    at = strstr(golden->text, pattern);
    CHECK(at != NULL);
    return at == NULL ? 0 : strtoll(at + strlen(pattern), NULL, 10);
}

static bool is_kind(const struct golden *golden, const char *kind)
{
    return strncmp(golden->text, kind, strlen(kind)) == 0 && golden->text[strlen(kind)] == ' ';
}

static bool is_taken(const struct golden *golden)
{
    struct frame_parser parser;
    unsigned frames = 0;

    frame_parser_begin(&parser);
    for (unsigned i = 0; i < FRAME_LENGTH; i++) {
        frames += frame_parser_add(&parser, golden->frame[i]);
    }
    return frames == 1;
}

static void check_start(const struct golden *golden, const struct path_start *start)
{
    CHECK_EQUAL(value(golden, "x_um"), pose_um(start->here.x_um_q16));
    CHECK_EQUAL(value(golden, "y_um"), pose_um(start->here.y_um_q16));
    CHECK_NEAR(value(golden, "heading_urad"), angle_urad(start->here.heading), 1);
    CHECK_EQUAL(value(golden, "pace_q15"), start->pace_q15);
    CHECK_EQUAL(value(golden, "acceleration_mm_s2"), start->limits.acceleration_mm_s2);
    CHECK_EQUAL(value(golden, "turn_acceleration_mrad_s2"),
                start->limits.turn_acceleration_mrad_s2);
}

static void check_segments(const struct golden *golden, const struct path_segments *more)
{
    CHECK_EQUAL(value(golden, "onward"), more->is_onward);
    CHECK_EQUAL(value(golden, "count"), more->count);
    for (unsigned i = 0; i < more->count; i++) {
        char key[16];

        snprintf(key, sizeof key, "v%u_um_s", i + 1);
        CHECK_EQUAL(value(golden, key), more->segments[i].v_um_s);
        snprintf(key, sizeof key, "w%u_urad_s", i + 1);
        CHECK_EQUAL(value(golden, key), more->segments[i].w_urad_s);
        snprintf(key, sizeof key, "t%u_us", i + 1);
        CHECK_EQUAL(value(golden, key), more->segments[i].duration_us);
    }
}

static int64_t joint_value(const struct golden *golden, int joint, const char *key)
{
    char whole[32];

    snprintf(whole, sizeof whole, "%s_%s", joint == 0 ? "shoulder" : "elbow", key);
    return value(golden, whole);
}

static void check_arm_settings(const struct golden *golden, const struct arm_settings *settings)
{
    for (int i = 0; i < ARM_JOINTS; i++) {
        const struct arm_joint_settings *joint = &settings->joints[i];

        CHECK_EQUAL(joint_value(golden, i, "least_urad"), joint->least_urad);
        CHECK_EQUAL(joint_value(golden, i, "most_urad"), joint->most_urad);
        CHECK_EQUAL(joint_value(golden, i, "rate_mrad_s"), joint->rate_mrad_s);
        CHECK_EQUAL(joint_value(golden, i, "acceleration_mrad_s2"), joint->acceleration_mrad_s2);
        CHECK_EQUAL(joint_value(golden, i, "pulse_least_us"), joint->pulse_least_us);
        CHECK_EQUAL(joint_value(golden, i, "pulse_most_us"), joint->pulse_most_us);
        CHECK_EQUAL(joint_value(golden, i, "mv_least"), joint->mv_least);
        CHECK_EQUAL(joint_value(golden, i, "mv_most"), joint->mv_most);
    }
    CHECK_EQUAL(value(golden, "open_us"), settings->open_us);
    CHECK_EQUAL(value(golden, "closed_us"), settings->closed_us);
    CHECK_EQUAL(value(golden, "empty_mv"), settings->empty_mv);
    CHECK_EQUAL(value(golden, "mv_a_kg"), settings->mv_a_kg);
}

static void check_command(const struct golden *golden)
{
    struct command command;

    CHECK_EQUAL(ANSWER_DONE, command_read(&command, golden->frame));
    CHECK_EQUAL(value(golden, "sequence"), command.sequence);
    switch (command.kind) {
    case COMMAND_POLL:
        CHECK(is_kind(golden, "poll"));
        break;
    case COMMAND_VELOCITY:
        CHECK(is_kind(golden, "velocity"));
        CHECK_EQUAL(value(golden, "vx_um_s"), command.as.velocity.vx_um_s);
        CHECK_EQUAL(value(golden, "vy_um_s"), command.as.velocity.vy_um_s);
        CHECK_EQUAL(value(golden, "w_urad_s"), command.as.velocity.w_urad_s);
        break;
    case COMMAND_PATH:
        CHECK(is_kind(golden, "path"));
        CHECK_EQUAL(value(golden, "number"), command.as.path.more.path);
        check_start(golden, &command.as.path.start);
        check_segments(golden, &command.as.path.more);
        break;
    case COMMAND_SEGMENTS:
        CHECK(is_kind(golden, "segments"));
        CHECK_EQUAL(value(golden, "path"), command.as.path.more.path);
        CHECK_EQUAL(value(golden, "first"), command.as.path.more.first);
        check_segments(golden, &command.as.path.more);
        break;
    case COMMAND_CLEAR:
        CHECK(is_kind(golden, "clear"));
        CHECK_EQUAL(value(golden, "reasons"), command.as.clear.reasons);
        CHECK_EQUAL(value(golden, "by"), command.as.clear.by_person);
        break;
    case COMMAND_SETTINGS:
        CHECK(is_kind(golden, "settings"));
        CHECK_EQUAL(value(golden, "wheel_radius_um"), command.as.settings.wheel_radius_um);
        CHECK_EQUAL(value(golden, "centre_to_wheel_um"), command.as.settings.centre_to_wheel_um);
        for (unsigned i = 0; i < BODY_FLOOR_SENSORS; i++) {
            char key[16];

            snprintf(key, sizeof key, "floor%u_mv", i + 1);
            CHECK_EQUAL(value(golden, key), command.as.settings.floor_mv[i]);
        }
        break;
    case COMMAND_ARM_SETTINGS:
        CHECK(is_kind(golden, "arm_settings"));
        check_arm_settings(golden, &command.as.arm_settings);
        break;
    case COMMAND_ARM_MOVE:
        CHECK(is_kind(golden, "arm_move"));
        CHECK_EQUAL(value(golden, "shoulder_urad"), command.as.arm_goal.urad[0]);
        CHECK_EQUAL(value(golden, "elbow_urad"), command.as.arm_goal.urad[1]);
        CHECK_EQUAL(value(golden, "closed"), command.as.arm_goal.is_hand_closed);
        CHECK_EQUAL(value(golden, "onward"), command.as.arm_goal.is_onward);
        break;
    case COMMAND_ARM_POLL:
        CHECK(is_kind(golden, "arm_poll"));
        break;
    case COMMAND_CAPTION:
        CHECK(is_kind(golden, "caption"));
        CHECK(memcmp(strstr(golden->text, "text=") + 5, command.as.caption, CAPTION_LENGTH) == 0);
        break;
    }
}

static void check_status(const struct golden *golden)
{
    uint8_t frame[FRAME_LENGTH];
    struct status status = {
        .sequence = (uint8_t)value(golden, "sequence"),
        .answer = (enum answer)value(golden, "answer"),
        .state = (enum robot_state)value(golden, "state"),
        .stop_reasons = (uint16_t)value(golden, "reasons"),
        .power_cycle = (uint16_t)value(golden, "power_cycle"),
        .stamp_ms = (uint32_t)value(golden, "stamp_ms"),
        .counts = {(int32_t)value(golden, "count1"), (int32_t)value(golden, "count2"),
                   (int32_t)value(golden, "count3")},
        .x_um = (int32_t)value(golden, "x_um"),
        .y_um = (int32_t)value(golden, "y_um"),
        .heading_urad = (int32_t)value(golden, "heading_urad"),
        .range_mm = {(uint16_t)value(golden, "range1_mm"), (uint16_t)value(golden, "range2_mm"),
                     (uint16_t)value(golden, "range3_mm")},
        .battery_mv = (uint16_t)value(golden, "battery_mv"),
        .missing_floor = (uint8_t)value(golden, "floor"),
        .pressed_switches = (uint8_t)value(golden, "switches"),
        .temperature = (int8_t)value(golden, "temperature"),
        .queue_free = (uint8_t)value(golden, "queue_free"),
        .segments_driven = (uint16_t)value(golden, "segments"),
        .path = (uint16_t)value(golden, "path"),
        .pace = (uint8_t)value(golden, "pace"),
        .covered_us = (uint32_t)value(golden, "covered_us"),
        .bad_frames = (uint16_t)value(golden, "bad"),
        .lost_bytes = (uint16_t)value(golden, "lost"),
    };

    status_write(&status, frame);
    for (unsigned i = 0; i < FRAME_LENGTH; i++) {
        CHECK_EQUAL(golden->frame[i], frame[i]);
    }
}

static void check_arm_status(const struct golden *golden)
{
    uint8_t frame[FRAME_LENGTH];
    struct status status = {
        .sequence = (uint8_t)value(golden, "sequence"),
        .answer = (enum answer)value(golden, "answer"),
        .state = (enum robot_state)value(golden, "state"),
        .stop_reasons = (uint16_t)value(golden, "reasons"),
        .power_cycle = (uint16_t)value(golden, "power_cycle"),
        .stamp_ms = (uint32_t)value(golden, "stamp_ms"),
        .bad_frames = (uint16_t)value(golden, "bad"),
        .lost_bytes = (uint16_t)value(golden, "lost"),
    };
    struct arm_report arm = {
        .state = (enum arm_state)value(golden, "arm"),
        .is_hand_closed = value(golden, "closed") == 1,
        .angle_urad = {(int32_t)value(golden, "shoulder_urad"),
                       (int32_t)value(golden, "elbow_urad")},
        .goal_urad = {(int32_t)value(golden, "shoulder_goal_urad"),
                      (int32_t)value(golden, "elbow_goal_urad")},
        .load_g = (uint16_t)value(golden, "load_g"),
        .progress = (uint8_t)value(golden, "progress"),
    };

    status_write_arm(&status, &arm, frame);
    for (unsigned i = 0; i < FRAME_LENGTH; i++) {
        CHECK_EQUAL(golden->frame[i], frame[i]);
    }
}

static bool read_golden(struct golden *golden, const char *line)
{
    const char *bar = strchr(line, '|');
    size_t length;

    if (line[0] == '#' || bar == NULL) {
        return false;
    }
    length = (size_t)(bar - line);
    memcpy(golden->text, line, length);
    golden->text[length] = '\0';
    for (unsigned i = 0; i < FRAME_LENGTH; i++) {
        unsigned byte;

        CHECK_EQUAL(1, sscanf(bar + 2 + 2 * i, "%2x", &byte));
        golden->frame[i] = (uint8_t)byte;
    }
    return true;
}

void golden_tests(const char *file)
{
    char line[1536];
    unsigned found = 0;
    FILE *stream = fopen(file, "r");

    CHECK(stream != NULL);
    while (stream != NULL && fgets(line, sizeof line, stream) != NULL) {
        struct golden golden;

        if (!read_golden(&golden, line)) {
            continue;
        }
        found++;
        CHECK_EQUAL(!is_kind(&golden, "bad"), is_taken(&golden));
        if (is_kind(&golden, "status")) {
            check_status(&golden);
        } else if (is_kind(&golden, "arm_status")) {
            check_arm_status(&golden);
        } else if (!is_kind(&golden, "bad")) {
            check_command(&golden);
        }
    }
    CHECK(found > 10);
    if (stream != NULL) {
        fclose(stream);
    }
}
