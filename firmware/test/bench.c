#include "bench.h"

#include <string.h>

#include "bench_drive.h"
#include "bytes.h"
#include "drive.h"

void bench_begin(struct bench *bench)
{
    struct settings settings = settings_default();
    static const struct arm_settings no_arm;

    memset(bench, 0, sizeof *bench);
    bench_drive_begin(&bench->rig);
    bench->inputs.battery_mv = 16000;
    for (int i = 0; i < BODY_FLOOR_SENSORS; i++) {
        bench->inputs.floor_mv[i] = 3000;
    }
    robot_begin(&bench->robot, STOP_POWER_UP, 1, &settings, &no_arm);
}

void bench_live(struct bench *bench, uint32_t ms)
{
    for (uint32_t i = 0; i < ms; i++) {
        bench->now_ms++;
        while (bench->rig_seconds < bench->now_ms / 1000.0) {
            bench_drive_sample();
            bench->rig_seconds += BENCH_DRIVE_SAMPLE;
        }
        robot_update(&bench->robot, &bench->inputs, bench->now_ms);
        if (bench->now_ms % DRIVE_PERIOD_MS == 0) {
            robot_control_wheels(&bench->robot);
        }
    }
}

static enum answer say(struct bench *bench, uint8_t frame[FRAME_LENGTH], enum command_kind kind)
{
    frame_seal(frame, (uint8_t)kind, ++bench->sequence);
    robot_handle_frame(&bench->robot, frame);
    return bench_status(bench).answer;
}

static void put_segments(uint8_t *at, const struct segment *segments, uint8_t count)
{
    *at++ = count;
    for (uint8_t i = 0; i < count; i++, at += 12) {
        put_i32(at, segments[i].v_um_s);
        put_i32(at + 4, segments[i].w_urad_s);
        put_u32(at + 8, segments[i].duration_us);
    }
}

void bench_live_polled(struct bench *bench, uint32_t ms)
{
    for (uint32_t i = 0; i < ms; i += 20) {
        uint8_t frame[FRAME_LENGTH] = {0};

        frame_seal(frame, COMMAND_POLL, 0);
        robot_handle_frame(&bench->robot, frame);
        bench_live(bench, 20);
    }
}

enum answer bench_velocity(struct bench *bench, int32_t vx, int32_t vy, int32_t w)
{
    uint8_t frame[FRAME_LENGTH] = {0};

    put_i32(frame + 4, vx);
    put_i32(frame + 8, vy);
    put_i32(frame + 12, w);
    return say(bench, frame, COMMAND_VELOCITY);
}

enum answer bench_path(struct bench *bench, uint16_t number, const struct segment *segments,
                       uint8_t count)
{
    uint8_t frame[FRAME_LENGTH] = {0};
    struct status now = bench_status(bench);

    put_u16(frame + 4, number);
    put_i32(frame + 6, now.x_um);
    put_i32(frame + 10, now.y_um);
    put_i32(frame + 14, now.heading_urad);
    put_u16(frame + 20, 500);
    put_u16(frame + 22, 3000);
    frame[24] = 1;
    put_segments(frame + 25, segments, count);
    return say(bench, frame, COMMAND_PATH);
}

enum answer bench_segments(struct bench *bench, uint16_t path, uint16_t first, bool is_onward,
                           const struct segment *segments, uint8_t count)
{
    uint8_t frame[FRAME_LENGTH] = {0};

    put_u16(frame + 4, path);
    put_u16(frame + 6, first);
    frame[8] = is_onward;
    put_segments(frame + 9, segments, count);
    return say(bench, frame, COMMAND_SEGMENTS);
}

enum answer bench_clear(struct bench *bench, uint16_t reasons, bool by_person)
{
    uint8_t frame[FRAME_LENGTH] = {0};

    put_u16(frame + 4, reasons);
    frame[6] = by_person;
    return say(bench, frame, COMMAND_CLEAR);
}

enum answer bench_settings(struct bench *bench, const struct settings *settings)
{
    uint8_t frame[FRAME_LENGTH] = {0};

    put_u32(frame + 4, settings->wheel_radius_um);
    put_u32(frame + 8, settings->centre_to_wheel_um);
    for (int i = 0; i < BODY_FLOOR_SENSORS; i++) {
        put_u16(frame + 12 + 2 * i, settings->floor_mv[i]);
    }
    return say(bench, frame, COMMAND_SETTINGS);
}

enum answer bench_arm_settings(struct bench *bench, const struct arm_settings *settings)
{
    uint8_t frame[FRAME_LENGTH] = {0};
    uint8_t *at = frame + 4;

    for (int i = 0; i < ARM_JOINTS; i++, at += 20) {
        const struct arm_joint_settings *joint = &settings->joints[i];

        put_i32(at, joint->least_urad);
        put_i32(at + 4, joint->most_urad);
        put_u16(at + 8, joint->rate_mrad_s);
        put_u16(at + 10, joint->acceleration_mrad_s2);
        put_u16(at + 12, joint->pulse_least_us);
        put_u16(at + 14, joint->pulse_most_us);
        put_u16(at + 16, joint->mv_least);
        put_u16(at + 18, joint->mv_most);
    }
    put_u16(at, settings->open_us);
    put_u16(at + 2, settings->closed_us);
    put_u16(at + 4, settings->empty_mv);
    put_u16(at + 6, settings->mv_a_kg);
    return say(bench, frame, COMMAND_ARM_SETTINGS);
}

enum answer bench_arm(struct bench *bench, const struct arm_goal *goal)
{
    uint8_t frame[FRAME_LENGTH] = {0};

    put_i32(frame + 4, goal->urad[0]);
    put_i32(frame + 8, goal->urad[1]);
    frame[12] = goal->is_hand_closed;
    frame[13] = goal->is_onward;
    return say(bench, frame, COMMAND_ARM_MOVE);
}

struct status bench_status(const struct bench *bench)
{
    struct status status;

    robot_fill_status(&bench->robot, &status);
    return status;
}
