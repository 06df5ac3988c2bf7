/* Modelled LM629 on the bench. */
#include "lm629_bench.h"

#include "bench_drive.h"
#include "lm629_bus.h"

enum { BUSY_LOOKS = 8 };

static struct rig *motors;
static struct lm629_model controllers[RIG_WHEELS];
static unsigned looks[RIG_WHEELS];

void bench_drive_begin(struct rig *rig)
{
    motors = rig;
    for (int i = 0; i < RIG_WHEELS; i++) {
        lm629_model_begin(&controllers[i], &rig->motors[i]);
    }
}

void bench_drive_sample(void)
{
    double duties[RIG_WHEELS];

    for (int i = 0; i < RIG_WHEELS; i++) {
        duties[i] = lm629_model_sample(&controllers[i]);
    }
    rig_turn(motors, duties, LM629_MODEL_SAMPLE);
}

struct lm629_model *lm629_bench_controller(int wheel)
{
    return &controllers[wheel];
}

void lm629_bus_reset(void)
{
    for (int i = 0; i < RIG_WHEELS; i++) {
        lm629_model_reset(&controllers[i]);
    }
}

void lm629_bus_command(uint8_t axis, uint8_t command)
{
    lm629_model_command(&controllers[axis], command);
    looks[axis] = 0;
}

void lm629_bus_write(uint8_t axis, uint8_t data)
{
    lm629_model_write(&controllers[axis], data);
    looks[axis] = 0;
}

uint8_t lm629_bus_status(uint8_t axis)
{
    if (++looks[axis] > BUSY_LOOKS) {
        lm629_model_rest(&controllers[axis]);
    }
    return lm629_model_status(&controllers[axis]);
}

uint8_t lm629_bus_read(uint8_t axis)
{
    looks[axis] = 0;
    return lm629_model_read(&controllers[axis]);
}
