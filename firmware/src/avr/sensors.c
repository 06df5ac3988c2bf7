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
    uint8_t sensor;

    if (channel == BATTERY_CHANNEL) {
        inputs->battery_mv = (uint16_t)(mv * BATTERY_DIVIDER);
        return;
    }
    sensor = (uint8_t)(1U << (channel - FLOOR_CHANNEL));
    if (mv < FLOOR_MISSING_MV) {
        inputs->missing_floor |= sensor;
    } else {
        inputs->missing_floor &= (uint8_t)~sensor;
    }
}

void sensors_begin(struct robot_inputs *inputs)
{
    ALARM_PORT |= ALARM_HEAT | ALARM_SWITCH; /* pull-ups */
    ADCSRA = _BV(ADEN) | _BV(ADPS2) | _BV(ADPS1) | _BV(ADPS0); /* clock/128 */
    for (channel = 0; channel <= FLOOR_SENSORS; channel++) {
        start();
        while ((ADCSRA & _BV(ADSC)) != 0) {
            /* 25 ADC clocks at most */
        }
        take(inputs);
    }
    channel = 0;
    start();
}

void sensors_sample(struct robot_inputs *inputs)
{
    inputs->is_hot = (ALARM_PIN & ALARM_HEAT) == 0;
    inputs->is_stop_pressed = (ALARM_PIN & ALARM_SWITCH) == 0;
    if ((ADCSRA & _BV(ADSC)) == 0) {
        take(inputs);
        channel = (uint8_t)(channel == FLOOR_SENSORS ? 0 : channel + 1U);
        start();
    }
}
