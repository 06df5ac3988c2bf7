#include "sensors.h"

#include <avr/io.h>

#include "board.h"

static uint8_t channel;

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
    SWITCH_PORT |= SWITCH_2 | SWITCH_3 | SWITCH_4;
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

static uint8_t pressed_switches(void)
{
    unsigned released = SWITCH_PIN;
    unsigned pressed = 0;

    pressed |= (released & SWITCH_2) == 0 ? 1U << 0 : 0U;
    pressed |= (released & SWITCH_3) == 0 ? 1U << 1 : 0U;
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
        channel = (uint8_t)(channel == TEMPERATURE_CHANNEL ? 0 : channel + 1U);
        start();
    }
}
