#include "interrupt_meter.h"

#include <simavr/sim_interrupts.h>
#include <stddef.h>

/* simavr enters an interrupt in no time, and tells its return before the instruction's time. */
enum { ENTRY_CYCLES = 4, RETURN_CYCLES = 4 };

static avr_t *chip;
static uint32_t longest[INTERRUPT_METER_VECTORS];

/* Those that run, the outermost one first. */
static struct {
    uint8_t vector;
    avr_cycle_count_t begun;
    uint32_t interrupted; /* cycles */
} running[INTERRUPT_METER_VECTORS];
static uint8_t depth;

static void begin(uint8_t vector)
{
    running[depth].vector = vector;
    running[depth].begun = chip->cycle;
    running[depth].interrupted = 0;
    depth++;
    chip->cycle += ENTRY_CYCLES;
}

static void end(void)
{
    uint32_t cycles = (uint32_t)(chip->cycle + RETURN_CYCLES - running[--depth].begun);
    uint32_t own = cycles - running[depth].interrupted;
    uint8_t vector = running[depth].vector;

    if (own > longest[vector]) {
        longest[vector] = own;
    }
    if (depth > 0) {
        running[depth - 1].interrupted += cycles;
    }
}

static void on_interrupt(avr_irq_t *irq, uint32_t is_running, void *parameter)
{
    (void)irq;
    if (is_running != 0) {
        begin((uint8_t)(uintptr_t)parameter);
    } else if (depth > 0) {
        end();
    }
}

void interrupt_meter_begin(avr_t *avr)
{
    chip = avr;
    for (uint8_t vector = 1; vector < INTERRUPT_METER_VECTORS; vector++) {
        avr_irq_t *irq = avr_get_interrupt_irq(avr, vector);

        if (irq != NULL) {
            avr_irq_register_notify(irq + AVR_INT_IRQ_RUNNING, on_interrupt,
                                    (void *)(uintptr_t)vector);
        }
    }
}

void interrupt_meter_restart(void)
{
    depth = 0;
}

bool interrupt_meter_runs(uint8_t vector)
{
    for (uint8_t i = 0; i < depth; i++) {
        if (running[i].vector == vector) {
            return true;
        }
    }
    return false;
}

uint32_t interrupt_meter_longest(uint8_t vector)
{
    return longest[vector];
}
