/*
 * One LM629 on its motor and encoder, as the data sheet tells it (SNVS781): host interface with
 * busy bit and command errors, trajectory generator in velocity mode, PID filter, 8-bit PWM. Of the
 * commands, those that firmware/src/lm629.c uses; any other one is a command error.
 */
#ifndef LM629_MODEL_H
#define LM629_MODEL_H

#include <stdbool.h>
#include <stdint.h>

#include "rig.h"

/* Seconds: 2048 clocks at 6 MHz. */
#define LM629_MODEL_SAMPLE (2048 / 6e6)

struct lm629_trajectory {
    uint16_t word;
    int32_t acceleration; /* counts a sample squared, times 2^16 */
    int32_t velocity;     /* counts a sample times 2^16, without sign */
};

struct lm629_model {
    const struct motor *motor;
    double home; /* counts of the motor where the position was 0 */

    /* host interface */
    uint8_t status;
    bool is_busy;
    bool is_dead; /* never ready again */
    uint8_t command;
    uint8_t data[16];
    uint8_t written;
    uint8_t expected;
    uint8_t answer[4];
    uint8_t answered;
    uint32_t rudenesses; /* bytes written while it was busy */

    /* buffered, and in use after STT or UDF */
    struct lm629_trajectory loaded;
    int32_t acceleration;
    int32_t target_velocity;
    uint16_t filter_word;
    int16_t loaded_kp;
    int16_t loaded_kd;
    int16_t kp;
    int16_t kd;
    uint16_t most_error;

    /* trajectory */
    bool is_driving;
    int64_t desired_q16; /* counts */
    int32_t velocity;    /* counts a sample times 2^16 */
    int32_t last_error;
    int32_t derivative;
    uint8_t derivative_age; /* samples */
};

/* Switched on, at this motor, which must last as long. */
void lm629_model_begin(struct lm629_model *model, const struct motor *motor);

void lm629_model_reset(struct lm629_model *model);
void lm629_model_command(struct lm629_model *model, uint8_t command);
void lm629_model_write(struct lm629_model *model, uint8_t data);
uint8_t lm629_model_status(const struct lm629_model *model);
uint8_t lm629_model_read(struct lm629_model *model);

/* What made it busy is done. */
void lm629_model_rest(struct lm629_model *model);

/* Begins the next sample. Returns the duty that the motor gets in it, -1 to 1. */
double lm629_model_sample(struct lm629_model *model);

#endif
