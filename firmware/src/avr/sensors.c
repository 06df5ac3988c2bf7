#include "sensors.h"

#include <avr/io.h>

#include "board.h"

static uint8_t channel;
static uint8_t next_channel; /* behind that of the arm */

enum { ARM_NOT_ASKED, ARM_ASKED, ARM_MEASURED };
static uint8_t arm;
static uint16_t arm_mv;

static uint16_t millivolts(void)
{
    return (uint16_t)((uint32_t)ADC * ADC_REFERENCE_MV >> 10);
}

static void start(void)
{
    ADMUX = (uint8_t)(_BV(REFS0) | channel); /* reference: AVCC */
    ADCSRA |= _BV(ADSC);
}

static void take(struct robot_inputs *inputs)
{
    uint16_t mv = millivolts();

    switch (channel) {
    case BATTERY_CHANNEL:
        inputs->battery_mv = (uint16_t)(mv * BATTERY_DIVIDER);
        break;
    case ARM_ADC_CHANNEL: /* from the middle of a step: a joint stands by it */
        arm_mv = (uint16_t)(((uint32_t)ADC * 2U + 1U) * ADC_REFERENCE_MV >> 11);
        arm = ARM_MEASURED;
        break;
    case TEMPERATURE_CHANNEL:
        mv = (uint16_t)((mv + MV_A_DEGREE / 2) / MV_A_DEGREE);
        inputs->temperature = (int8_t)(mv > INT8_MAX ? INT8_MAX : mv);
        break;
    default:
        inputs->floor_mv[channel - FLOOR_CHANNEL] = mv;
        break;
    }
}

void sensors_begin(struct robot_inputs *inputs)
{
    ALARM_PORT |= ALARM_HEAT | ALARM_SWITCH; /* pull-ups */
    SWITCH_PORT |= SWITCH_2 | SWITCH_4;
    SWITCH_3_PORT |= SWITCH_3;
    ADCSRA = _BV(ADEN) | _BV(ADPS2) | _BV(ADPS1) | _BV(ADPS0); /* clock/128 */
    for (channel = 0; channel <= TEMPERATURE_CHANNEL; channel++) {
        start();
        while ((ADCSRA & _BV(ADSC)) != 0) {
            /* 25 ADC clocks at most */
        }
        take(inputs);
    }
    channel = 0;
    start();
}

static uint8_t channel_after(uint8_t this)
{
    return (uint8_t)(this == TEMPERATURE_CHANNEL ? 0 : this + 1U);
}

/* That of the arm comes between two others. */
static void choose_channel(void)
{
    if (channel == ARM_ADC_CHANNEL) {
        channel = next_channel;
        return;
    }
    next_channel = channel_after(channel);
    channel = arm == ARM_ASKED ? ARM_ADC_CHANNEL : next_channel;
}

void sensors_ask_arm(void)
{
    arm = ARM_ASKED;
}

bool sensors_take_arm(uint16_t *mv)
{
    if (arm != ARM_MEASURED) {
        return false;
    }
    arm = ARM_NOT_ASKED;
    *mv = arm_mv;
    return true;
}

static uint8_t pressed_switches(void)
{
    unsigned released = SWITCH_PIN;
    unsigned pressed = 0;

    pressed |= (released & SWITCH_2) == 0 ? 1U << 0 : 0U;
    pressed |= (SWITCH_3_PIN & SWITCH_3) == 0 ? 1U << 1 : 0U;
    pressed |= (released & SWITCH_4) == 0 ? 1U << 2 : 0U;
    return (uint8_t)pressed;
}

void sensors_sample(struct robot_inputs *inputs)
{
    inputs->is_hot = (ALARM_PIN & ALARM_HEAT) == 0;
    inputs->is_stop_pressed = (ALARM_PIN & ALARM_SWITCH) == 0;
    inputs->pressed_switches = pressed_switches();
    if ((ADCSRA & _BV(ADSC)) == 0) {
        take(inputs);
        choose_channel();
        start();
    }
}
