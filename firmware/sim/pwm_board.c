#include "pwm_board.h"

#include <math.h>
#include <simavr/avr_extint.h>
#include <simavr/avr_ioport.h>

/* Data space addresses of the ATmega128's registers. */
enum {
    DDRA_ADDRESS = 0x3A,
    PORTA_ADDRESS = 0x3B,
    DDRB_ADDRESS = 0x37,
    TCCR1A_ADDRESS = 0x4F,
    TCCR1B_ADDRESS = 0x4E,
};

static const uint16_t OCR1_ADDRESSES[RIG_WHEELS] = {0x4A, 0x48, 0x78}; /* low bytes of A, B, C */

enum {
    DIRECTION_0 = 1 << 0, /* port A */
    PWM_0 = 1 << 5,       /* port B */
    ENCODER_PIN_0 = 4,    /* A at port E, B at port A */
    ENCODER_INTERRUPT_0 = 4,

    WAVE_MASK = 0x03,
    PHASE_CORRECT_8_BITS = 0x01,
    CLOCK_MASK = 0x1F,
    UNDIVIDED = 0x01,
    OUTPUT_MASK = 0x03,
    NOT_INVERTED = 0x02,
    FULL = 255,
};

/* Seconds: a few periods of the PWM; an encoder has an edge in every other one at most. */
#define STEP 0.00005

/* A wheel's encoder in the step that runs. */
struct encoder {
    int wheel;
    int64_t shown; /* counts that its pins show */
    double from;   /* counts where the motor was at the step's beginning, and will be at its end */
    double to;
    avr_cycle_count_t begun;
};

static avr_t *chip;
static struct rig *motors;
static struct encoder encoders[RIG_WHEELS];

static avr_irq_t *pin(char name, int number)
{
    return avr_io_getirq(chip, (uint32_t)AVR_IOCTL_IOPORT_GETIRQ(name), IOPORT_IRQ_PIN0 + number);
}

/* Forwards A goes first: 00, 10, 11, 01. */
static bool a_of(int64_t counts)
{
    return (counts & 3) == 1 || (counts & 3) == 2;
}

static bool b_of(int64_t counts)
{
    return (counts & 2) != 0;
}

/* Else a write to the port would put its pull-ups on pins that the encoders hold. */
static void hold(char name, bool (*level_of)(int64_t))
{
    unsigned mask = 0;
    unsigned levels = 0;
    avr_ioport_external_t external;

    for (int i = 0; i < RIG_WHEELS; i++) {
        mask |= 1U << (ENCODER_PIN_0 + i);
        levels |= (unsigned)level_of(encoders[i].shown) << (ENCODER_PIN_0 + i);
    }
    external.name = (unsigned)name & 0x7FU;
    external.mask = mask & 0xFFU;
    external.value = levels & 0xFFU;
    avr_ioctl(chip, (uint32_t)AVR_IOCTL_IOPORT_SET_EXTERNAL(name), &external);
}

static void show(const struct encoder *encoder)
{
    hold('A', b_of);
    hold('E', a_of);
    avr_raise_irq(pin('A', ENCODER_PIN_0 + encoder->wheel), b_of(encoder->shown));
    avr_raise_irq(pin('E', ENCODER_PIN_0 + encoder->wheel), a_of(encoder->shown));
}

/* The cycle of the next edge in this step; 0 where there is none. */
static avr_cycle_count_t next_edge(const struct encoder *encoder)
{
    bool is_forward = encoder->to > encoder->from;
    double edge = (double)(is_forward ? encoder->shown + 1 : encoder->shown);
    double share = (edge - encoder->from) / (encoder->to - encoder->from);

    if (is_forward ? edge > encoder->to : edge <= encoder->to) {
        return 0;
    }
    return encoder->begun +
           (avr_cycle_count_t)llround(share * STEP * chip->frequency);
}

static avr_cycle_count_t turn_on(avr_t *avr, avr_cycle_count_t when, void *parameter)
{
    struct encoder *encoder = parameter;

    (void)avr;
    (void)when;
    encoder->shown += encoder->to > encoder->from ? 1 : -1;
    show(encoder);
    return next_edge(encoder);
}

static double duty_of(int wheel)
{
    const uint8_t *data = chip->data;
    uint8_t output = data[TCCR1A_ADDRESS] >> (6 - 2 * wheel) & OUTPUT_MASK;
    bool is_backward = (data[PORTA_ADDRESS] & data[DDRA_ADDRESS] & (DIRECTION_0 << wheel)) != 0;
    double duty = data[OCR1_ADDRESSES[wheel]] / (double)FULL;

    if (output != NOT_INVERTED || (data[TCCR1A_ADDRESS] & WAVE_MASK) != PHASE_CORRECT_8_BITS ||
        (data[TCCR1B_ADDRESS] & CLOCK_MASK) != UNDIVIDED ||
        (data[DDRB_ADDRESS] & (PWM_0 << wheel)) == 0) {
        return 0;
    }
    return is_backward ? -duty : duty;
}

static void turn_encoder(struct encoder *encoder, double before)
{
    avr_cycle_count_t first;

    encoder->from = before;
    encoder->to = motors->motors[encoder->wheel].angle;
    encoder->begun = chip->cycle;
    first = next_edge(encoder);
    if (first != 0) {
        avr_cycle_timer_register(chip, first - chip->cycle, turn_on, encoder);
    }
}

static void turn(void)
{
    double duties[RIG_WHEELS];
    double before[RIG_WHEELS];

    for (int i = 0; i < RIG_WHEELS; i++) {
        duties[i] = duty_of(i);
        before[i] = motors->motors[i].angle;
    }
    rig_turn(motors, duties, STEP);
    for (int i = 0; i < RIG_WHEELS; i++) {
        turn_encoder(&encoders[i], before[i]);
    }
}

/* The chip has forgotten its pins, and edges that were to come. */
static void restart(void)
{
    for (int i = 0; i < RIG_WHEELS; i++) {
        encoders[i].wheel = i;
        encoders[i].shown = (int64_t)floor(motors->motors[i].angle);
        avr_raise_irq(pin('A', ENCODER_PIN_0 + i), !b_of(encoders[i].shown));
        avr_raise_irq(pin('E', ENCODER_PIN_0 + i), !a_of(encoders[i].shown));
        show(&encoders[i]);
    }
}

static void wire(avr_t *avr, struct rig *rig)
{
    chip = avr;
    motors = rig;
    for (uint8_t i = 0; i < RIG_WHEELS; i++) {
        /* else simavr would take a low pin for an interrupt that never ends */
        avr_extint_set_strict_lvl_trig(avr, (uint8_t)(ENCODER_INTERRUPT_0 + i), 0);
    }
    restart();
}

const struct drive_model pwm_board = {
    .seconds = STEP, .wire = wire, .restart = restart, .turn = turn};
