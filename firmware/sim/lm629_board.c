#include "lm629_board.h"

#include <simavr/avr_ioport.h>
#include <simavr/sim_time.h>
#include <stddef.h>

/* Data space address of the ATmega128's register. */
enum { PORTA_ADDRESS = 0x3B };

enum {
    LM629_PS = 1 << 0,
    LM629_RD = 1 << 1,
    LM629_WR = 1 << 2,
    LM629_CS_0 = 1 << 3,
    LM629_RST = 1 << 6,

    NO_WHEEL = -1,
};

static avr_t *chip;
static struct rig *motors;
static struct lm629_model controllers[RIG_WHEELS];
static uint8_t lines_before;

/* Every command and word keeps it busy for as long as lm629.c allows it at most. */
enum { BUSY_US = 100 };
static avr_cycle_count_t busy_until[RIG_WHEELS];

/*
 * The controllers sample their motors, which turn all the time: 3.5 counts a sample at full speed,
 * half a count a step.
 */
enum { STEPS_A_SAMPLE = 8 };
#define STEP (LM629_MODEL_SAMPLE / STEPS_A_SAMPLE)
static double duties[RIG_WHEELS];
static int step;

static avr_irq_t *port(char name, int irq)
{
    return avr_io_getirq(chip, (uint32_t)AVR_IOCTL_IOPORT_GETIRQ(name), irq);
}

static int selected(uint8_t lines)
{
    for (int i = 0; i < RIG_WHEELS; i++) {
        if ((lines & (LM629_CS_0 << i)) == 0) {
            return i;
        }
    }
    return NO_WHEEL;
}

static void begin_busy(int wheel)
{
    busy_until[wheel] = chip->cycle + avr_usec_to_cycles(chip, BUSY_US);
}

static void write(int wheel, bool is_command, uint8_t byte)
{
    if (is_command) {
        lm629_model_command(&controllers[wheel], byte);
    } else {
        lm629_model_write(&controllers[wheel], byte);
    }
    begin_busy(wheel);
}

static uint8_t status(int wheel)
{
    if (chip->cycle >= busy_until[wheel]) {
        lm629_model_rest(&controllers[wheel]);
    }
    return lm629_model_status(&controllers[wheel]);
}

static uint8_t read(int wheel)
{
    uint8_t byte = lm629_model_read(&controllers[wheel]);

    begin_busy(wheel);
    return byte;
}

static void drive_bus(uint8_t byte)
{
    for (int i = 0; i < 8; i++) {
        avr_raise_irq(port('A', IOPORT_IRQ_PIN0 + i), (byte >> i) & 1U);
    }
}

static void on_lines(avr_irq_t *irq, uint32_t value, void *parameter)
{
    uint8_t lines = (uint8_t)value;
    uint8_t fallen = (uint8_t)(lines_before & ~lines);
    uint8_t risen = (uint8_t)(lines & ~lines_before);
    bool is_command = (lines & LM629_PS) == 0;
    int wheel = selected(lines);

    (void)irq;
    (void)parameter;
    lines_before = lines;
    if ((fallen & LM629_RST) != 0) {
        for (int i = 0; i < RIG_WHEELS; i++) {
            lm629_model_reset(&controllers[i]);
        }
    }
    if (wheel == NO_WHEEL) {
        return;
    }
    if ((risen & LM629_WR) != 0) {
        write(wheel, is_command, chip->data[PORTA_ADDRESS]);
    }
    if ((fallen & LM629_RD) != 0) {
        drive_bus(is_command ? status(wheel) : read(wheel));
    }
}

static void wire(avr_t *avr, struct rig *rig)
{
    chip = avr;
    motors = rig;
    lines_before = 0xFF;
    step = 0;
    for (int i = 0; i < RIG_WHEELS; i++) {
        lm629_model_begin(&controllers[i], &rig->motors[i]);
    }
    avr_irq_register_notify(port('C', IOPORT_IRQ_REG_PORT), on_lines, NULL);
}

/* The controllers do not notice; the program resets them by their line. */
static void restart(void)
{
}

static void turn(void)
{
    for (int i = 0; step == 0 && i < RIG_WHEELS; i++) {
        duties[i] = lm629_model_sample(&controllers[i]);
    }
    step = (step + 1) % STEPS_A_SAMPLE;
    rig_turn(motors, duties, STEP);
}

const struct drive_model lm629_board = {
    .seconds = STEP, .wire = wire, .restart = restart, .turn = turn};

struct lm629_model *lm629_board_controllers(void)
{
    return controllers;
}
