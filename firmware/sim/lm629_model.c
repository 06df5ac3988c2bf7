#include "lm629_model.h"

#include <math.h>
#include <string.h>

#include "lm629_codes.h"

void lm629_model_begin(struct lm629_model *model, const struct motor *motor)
{
    memset(model, 0, sizeof *model);
    model->motor = motor;
    lm629_model_reset(model);
}

void lm629_model_reset(struct lm629_model *model)
{
    struct lm629_model before = *model;

    memset(model, 0, sizeof *model);
    model->motor = before.motor;
    model->home = floor(before.motor->angle);
    model->is_dead = before.is_dead;
    model->rudenesses = before.rudenesses;
    model->status = LM629_MOTOR_OFF | LM629_COMPLETE;
    model->most_error = 0x7FFF;
}

static bool is_rude(struct lm629_model *model)
{
    if (!model->is_busy && !model->is_dead) {
        return false;
    }
    model->rudenesses++;
    return true;
}

static int32_t position(const struct lm629_model *model)
{
    return (int32_t)(int64_t)floor(model->motor->angle - model->home);
}

static uint16_t word_at(const struct lm629_model *model, uint8_t at)
{
    return (uint16_t)(model->data[at] << 8 | model->data[at + 1]);
}

static int32_t long_at(const struct lm629_model *model, uint8_t at)
{
    return (int32_t)((uint32_t)word_at(model, at) << 16 | word_at(model, (uint8_t)(at + 2)));
}

static uint8_t trajectory_length(uint16_t word)
{
    return (uint8_t)(2 + ((word & LM629_HAS_ACCELERATION) != 0 ? 4 : 0) +
                     ((word & LM629_HAS_VELOCITY) != 0 ? 4 : 0));
}

static uint8_t filter_length(uint16_t word)
{
    uint8_t length = 2;

    for (unsigned bit = LM629_HAS_LIMIT; bit <= LM629_HAS_PROPORTIONAL; bit <<= 1) {
        length = (uint8_t)(length + ((word & bit) != 0 ? 2 : 0));
    }
    return length;
}

static void load_trajectory(struct lm629_model *model)
{
    uint8_t at = 2;

    model->loaded.word = word_at(model, 0);
    if ((model->loaded.word & LM629_HAS_ACCELERATION) != 0) {
        model->loaded.acceleration = long_at(model, at);
        at = (uint8_t)(at + 4);
        if (model->is_driving) {
            model->status |= LM629_COMMAND_ERROR;
        }
    }
    if ((model->loaded.word & LM629_HAS_VELOCITY) != 0) {
        model->loaded.velocity = long_at(model, at);
    }
}

static void load_filter(struct lm629_model *model)
{
    uint8_t at = 2;

    model->filter_word = word_at(model, 0);
    for (unsigned bit = LM629_HAS_PROPORTIONAL; bit >= LM629_HAS_LIMIT; bit >>= 1) {
        if ((model->filter_word & bit) == 0) {
            continue;
        }
        if (bit == LM629_HAS_PROPORTIONAL) {
            model->loaded_kp = (int16_t)word_at(model, at);
        } else if (bit == LM629_HAS_DERIVATIVE) {
            model->loaded_kd = (int16_t)word_at(model, at);
        }
        at = (uint8_t)(at + 2);
    }
}

static void hold_here(struct lm629_model *model)
{
    model->desired_q16 = (int64_t)position(model) * 65536;
    model->velocity = 0;
    model->target_velocity = 0;
}

static void start(struct lm629_model *model)
{
    uint16_t word = model->loaded.word;

    model->acceleration = model->loaded.acceleration;
    if ((model->status & LM629_MOTOR_OFF) != 0) {
        hold_here(model);
        model->last_error = 0;
    }
    model->status &= (uint8_t)~(LM629_MOTOR_OFF | LM629_COMPLETE);
    if ((word & LM629_TURN_MOTOR_OFF) != 0) {
        model->is_driving = false;
        model->status |= LM629_MOTOR_OFF | LM629_COMPLETE;
    } else if ((word & LM629_STOP_ABRUPTLY) != 0) {
        hold_here(model);
        model->is_driving = false;
        model->status |= LM629_COMPLETE;
    } else if ((word & LM629_VELOCITY_MODE) != 0) {
        model->target_velocity =
            (word & LM629_FORWARD) != 0 ? model->loaded.velocity : -model->loaded.velocity;
        model->is_driving = true;
    } else {
        model->status |= LM629_COMMAND_ERROR;
    }
}

void lm629_model_command(struct lm629_model *model, uint8_t command)
{
    int32_t counts = position(model);

    if (is_rude(model)) {
        return;
    }
    if (model->written < model->expected) {
        model->status |= LM629_COMMAND_ERROR;
    }
    model->command = command;
    model->written = 0;
    model->expected = 0;
    model->answered = sizeof model->answer;
    model->is_busy = true;
    switch (command) {
    case LM629_RESET:
        lm629_model_reset(model);
        break;
    case LM629_START:
        start(model);
        break;
    case LM629_UPDATE_FILTER:
        model->kp = model->loaded_kp;
        model->kd = model->loaded_kd;
        break;
    case LM629_READ_POSITION:
        for (uint8_t i = 0; i < sizeof model->answer; i++) {
            model->answer[i] = (uint8_t)((uint32_t)counts >> (24 - 8 * i));
        }
        model->answered = 0;
        break;
    case LM629_LIMIT_AND_STOP:
    case LM629_RESET_INTERRUPTS:
    case LM629_LOAD_FILTER:
    case LM629_LOAD_TRAJECTORY:
        model->expected = 2;
        break;
    default:
        model->status |= LM629_COMMAND_ERROR;
    }
}

static void obey(struct lm629_model *model)
{
    switch (model->command) {
    case LM629_LIMIT_AND_STOP:
        model->most_error = word_at(model, 0);
        break;
    case LM629_RESET_INTERRUPTS:
        model->status &= (uint8_t)(word_at(model, 0) | LM629_MOTOR_OFF | LM629_COMPLETE);
        break;
    case LM629_LOAD_FILTER:
        load_filter(model);
        break;
    case LM629_LOAD_TRAJECTORY:
        load_trajectory(model);
        break;
    default:
        break;
    }
}

void lm629_model_write(struct lm629_model *model, uint8_t data)
{
    bool is_first_of_word = model->written % 2 == 0;

    if (is_first_of_word && is_rude(model)) {
        return;
    }
    if (model->written == model->expected) {
        model->status |= LM629_COMMAND_ERROR;
        return;
    }
    model->data[model->written++] = data;
    if (is_first_of_word) {
        return;
    }
    model->is_busy = true;
    if (model->written == 2 && model->command == LM629_LOAD_TRAJECTORY) {
        model->expected = trajectory_length(word_at(model, 0));
    }
    if (model->written == 2 && model->command == LM629_LOAD_FILTER) {
        model->expected = filter_length(word_at(model, 0));
    }
    if (model->written == model->expected) {
        obey(model);
    }
}

uint8_t lm629_model_status(const struct lm629_model *model)
{
    if (model->is_dead) {
        return LM629_BUSY;
    }
    return model->is_busy ? model->status | LM629_BUSY : model->status;
}

void lm629_model_rest(struct lm629_model *model)
{
    model->is_busy = false;
}

uint8_t lm629_model_read(struct lm629_model *model)
{
    if (model->answered == sizeof model->answer) {
        model->status |= LM629_COMMAND_ERROR;
        return 0;
    }
    if (model->answered % 2 == 0) {
        if (is_rude(model)) {
            return 0;
        }
    } else {
        model->is_busy = true;
    }
    return model->answer[model->answered++];
}

static int32_t approached(int32_t value, int32_t wanted, int32_t change)
{
    if (wanted - value > change) {
        return value + change;
    }
    return value - wanted > change ? value - change : wanted;
}

static double pid(struct lm629_model *model, int32_t error)
{
    double output;

    if (model->derivative_age++ >= model->filter_word >> 8) {
        model->derivative = error - model->last_error;
        model->last_error = error;
        model->derivative_age = 0;
    }
    output = (model->kp * (double)error + model->kd * (double)model->derivative) / 256;
    return floor(fmax(-128, fmin(127, output))) / 128;
}

double lm629_model_sample(struct lm629_model *model)
{
    int32_t error;

    if ((model->status & LM629_MOTOR_OFF) != 0) {
        return 0;
    }
    model->velocity = approached(model->velocity, model->target_velocity, model->acceleration);
    model->desired_q16 += model->velocity;
    error = (int32_t)(model->desired_q16 >> 16) - position(model);
    if (error > model->most_error || error < -(int32_t)model->most_error) {
        model->status |= LM629_POSITION_ERROR | LM629_MOTOR_OFF;
        model->is_driving = false;
    }
    return pid(model, error);
}
