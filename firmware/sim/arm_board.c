#include "arm_board.h"

#include <math.h>
#include <simavr/avr_adc.h>
#include <simavr/avr_ioport.h>
#include <simavr/sim_time.h>
#include <stddef.h>

/* Data space addresses of the ATmega128's registers. */
enum {
    DDRE_ADDRESS = 0x22,
    DDRG_ADDRESS = 0x64,
    PORTG_ADDRESS = 0x65,
    ICR3_ADDRESS = 0x80,
    OCR3A_ADDRESS = 0x86,
    TCNT3_ADDRESS = 0x88,
    TCCR3B_ADDRESS = 0x8A,
    TCCR3A_ADDRESS = 0x8B,
};

enum {
    PULSE_PIN = 1 << 3, /* port E */
    SELECT_PIN_0 = 2,   /* port G */
    SELECT_MASK = 3,
    LOAD = 3,           /* what the multiplexer leads to the ADC beside joints and hand */
    ADC_CHANNEL = 7,

    CLEAR_AT_MATCH = 0x82, /* TCCR3A: COM3A1, WGM31 */
    UP_TO_ICR3 = 0x1A,     /* TCCR3B: WGM33, WGM32, clock/8 */
    PRESCALER = 8,

    FIRST_US = 500,
    SPAN_US = 2000,
    FIRST_MV = 500,
    SPAN_MV = 4000,
    MV_A_KG = 1000,

    PERIOD_US = 1000,
};

/* Shares a second: of 320 degrees, 640 degrees a second; the hand in 0.25 s. */
static const double RATE = 2.0;
static const double CLOSED = 0.75;
static const double OPEN = 0.25;

struct arm_board arm_board = {.shares = {0.875, 0.03125, 0.25}, .box_g = 1000};

static avr_t *chip;
static double targets[ARM_BOARD_SERVOS];
static bool is_told[ARM_BOARD_SERVOS];
static int selected;

static uint16_t word_at(int address)
{
    return (uint16_t)(chip->data[address] | chip->data[address + 1] << 8);
}

/* Microseconds; 0: there are no pulses. */
static double pulse_us(void)
{
    const uint8_t *data = chip->data;
    double a_us = chip->frequency / 1e6 / PRESCALER;

    if (data[TCCR3A_ADDRESS] != CLEAR_AT_MATCH || data[TCCR3B_ADDRESS] != UP_TO_ICR3 ||
        (data[DDRE_ADDRESS] & PULSE_PIN) == 0 || word_at(ICR3_ADDRESS) == 0) {
        return 0;
    }
    return (word_at(OCR3A_ADDRESS) + 1) / a_us;
}

static void measure(void)
{
    double mv = FIRST_MV;

    if (selected < ARM_BOARD_JOINTS) {
        mv += SPAN_MV * arm_board.shares[selected];
    } else if (selected == LOAD) {
        mv += arm_board.load_g * (double)MV_A_KG / 1000;
    }
    avr_raise_irq(avr_io_getirq(chip, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_ADC0 + ADC_CHANNEL),
                  (uint32_t)lround(mv));
}

/* The pulse that the servo has got which is selected: the next one is not yet told of. */
static void take_pulse(void)
{
    double us = pulse_us();

    if (us != 0 && selected < ARM_BOARD_SERVOS) {
        targets[selected] = fmax(0, fmin(1, (us - FIRST_US) / SPAN_US));
        is_told[selected] = true;
    }
}

static void on_select(avr_irq_t *irq, uint32_t value, void *parameter)
{
    int now = (int)(value >> SELECT_PIN_0 & SELECT_MASK);

    (void)irq;
    (void)parameter;
    if (now == selected || (chip->data[DDRG_ADDRESS] >> SELECT_PIN_0 & SELECT_MASK) != SELECT_MASK) {
        return;
    }
    /* the program has just read the count, which simavr then computes */
    if (pulse_us() != 0 && word_at(TCNT3_ADDRESS) <= word_at(OCR3A_ADDRESS)) {
        arm_board.cut_pulses++;
    }
    take_pulse();
    selected = now;
    measure();
}

static void grasp_or_let_go(double before, double now)
{
    if (before < CLOSED && now >= CLOSED && arm_board.box_g != 0) {
        arm_board.load_g = arm_board.box_g;
        arm_board.grasps++;
    } else if (before > OPEN && now <= OPEN + 1e-3 && arm_board.load_g != 0) {
        arm_board.load_g = 0;
        arm_board.releases++;
    }
}

static void turn(void)
{
    double most = RATE * PERIOD_US * 1e-6;

    for (int i = 0; i < ARM_BOARD_SERVOS; i++) {
        double before = arm_board.shares[i];

        if (!is_told[i] || (arm_board.is_stuck && i < ARM_BOARD_JOINTS)) {
            continue;
        }
        arm_board.shares[i] += fmax(-most, fmin(most, targets[i] - before));
        if (i == ARM_BOARD_JOINTS) {
            grasp_or_let_go(before, arm_board.shares[i]);
        }
    }
}

static avr_cycle_count_t live(avr_t *avr, avr_cycle_count_t when, void *parameter)
{
    (void)parameter;
    turn();
    measure();
    return when + avr_usec_to_cycles(avr, PERIOD_US);
}

void arm_board_wire(avr_t *avr)
{
    chip = avr;
    avr_irq_register_notify(
        avr_io_getirq(avr, (uint32_t)AVR_IOCTL_IOPORT_GETIRQ('G'), IOPORT_IRQ_REG_PORT), on_select,
        NULL);
    arm_board_restart();
}

void arm_board_restart(void)
{
    selected = 0;
    for (int i = 0; i < ARM_BOARD_SERVOS; i++) {
        is_told[i] = false; /* without pulses they stay where they are */
    }
    measure();
    avr_cycle_timer_register_usec(chip, PERIOD_US, live, NULL);
}
