/* A robot on the bench: its program over modelled hardware, driven by frames. */
#ifndef BENCH_H
#define BENCH_H

#include "rig.h"
#include "robot.h"

struct bench {
    struct rig rig;
    struct robot robot;
    struct robot_inputs inputs;
    uint8_t sequence;
    uint32_t now_ms;
    double rig_seconds;
};

void bench_begin(struct bench *bench);

/* Time passes and nobody says anything. */
void bench_live(struct bench *bench, uint32_t ms);

/* Time passes with a poll every 20 ms. */
void bench_live_polled(struct bench *bench, uint32_t ms);

enum answer bench_velocity(struct bench *bench, int32_t vx, int32_t vy, int32_t w);

/* Begins a path where the robot takes itself to be; the next frame bears the next sequence. */
enum answer bench_path(struct bench *bench, uint16_t number, const struct segment *segments,
                       uint8_t count);

enum answer bench_segments(struct bench *bench, uint16_t path, uint16_t first, bool is_onward,
                           const struct segment *segments, uint8_t count);
enum answer bench_clear(struct bench *bench, uint16_t reasons, bool by_person);
enum answer bench_settings(struct bench *bench, const struct settings *settings);
enum answer bench_arm_settings(struct bench *bench, const struct arm_settings *settings);
enum answer bench_arm(struct bench *bench, const struct arm_goal *goal);
struct status bench_status(const struct bench *bench);

#endif
