/* Motors and encoders at the microcontroller's own pins, on the bench. */
#include <math.h>
#include <string.h>

#include "bench_drive.h"
#include "check.h"
#include "pwm_bus.h"

/* Samples in PWM_BUS_MOVED_MS. */
enum { TRAIL = 59 };

static struct rig *motors;
static double duties[RIG_WHEELS];
static double ends[RIG_WHEELS]; /* seconds after pwm_bus_begin_time; 0: never */
static double seconds;
static double trail[RIG_WHEELS][TRAIL]; /* counts at the last samples */
static double moved[RIG_WHEELS];
static unsigned newest;

void bench_drive_begin(struct rig *rig)
{
    motors = rig;
}

void bench_drive_sample(void)
{
    seconds += BENCH_DRIVE_SAMPLE;
    for (int i = 0; i < RIG_WHEELS; i++) {
        if (ends[i] != 0 && seconds >= ends[i]) {
            ends[i] = 0;
            duties[i] = 0;
        }
    }
    rig_turn(motors, duties, BENCH_DRIVE_SAMPLE);
    newest = (newest + 1) % TRAIL;
    for (int i = 0; i < RIG_WHEELS; i++) {
        moved[i] = floor(motors->motors[i].angle) - trail[i][newest];
        trail[i][newest] = floor(motors->motors[i].angle);
    }
}

int32_t pwm_bus_moved(uint8_t wheel)
{
    return (int32_t)moved[wheel];
}

void pwm_bus_begin(void)
{
    memset(trail, 0, sizeof trail);
    memset(duties, 0, sizeof duties);
    memset(ends, 0, sizeof ends);
}

void pwm_bus_drive(uint8_t wheel, int16_t duty)
{
    CHECK(duty >= -PWM_FULL && duty <= PWM_FULL);
    duties[wheel] = duty / (double)PWM_FULL;
    ends[wheel] = 0;
}

void pwm_bus_drive_until(uint8_t wheel, int16_t duty, uint16_t ms_q4)
{
    pwm_bus_drive(wheel, duty);
    ends[wheel] = ceil(ms_q4 / 16.0) / 1000;
}

void pwm_bus_end_at(uint8_t wheel, uint16_t ms_q4)
{
    if (ends[wheel] != 0) {
        ends[wheel] = ceil(ms_q4 / 16.0) / 1000;
    }
}

void pwm_bus_begin_time(void)
{
    seconds = 0;
}

uint16_t pwm_bus_ms_q4(void)
{
    return (uint16_t)(fmin(seconds, 0.255) * 16000);
}

void pwm_bus_counts(int32_t counts[BODY_WHEELS])
{
    for (int i = 0; i < BODY_WHEELS; i++) {
        counts[i] = (int32_t)floor(motors->motors[i].angle);
    }
}
