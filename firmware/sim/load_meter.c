#include "load_meter.h"

#include <simavr/sim_time.h>
#include <stdbool.h>

static bool is_counting;
static avr_cycle_count_t period_end;
static avr_cycle_count_t woke;
static uint32_t busy;    /* cycles of the period that runs */
static uint32_t busiest; /* us */
static uint32_t longest;

static uint32_t greater(uint32_t a, uint32_t b)
{
    return a > b ? a : b;
}

static void end_period(const avr_t *avr)
{
    busiest = greater(busiest, avr_cycles_to_usec((avr_t *)avr, busy));
    busy = 0;
    period_end = avr->cycle + avr_usec_to_cycles((avr_t *)avr, LOAD_METER_PERIOD_US);
}

void load_meter_restart(void)
{
    is_counting = false;
}

void load_meter_step(const avr_t *avr, avr_cycle_count_t begun, int state)
{
    bool falls_asleep = state != cpu_Sleeping && avr->state == cpu_Sleeping;

    if (!is_counting) {
        if (!falls_asleep) {
            return;
        }
        is_counting = true;
        woke = begun;
        busy = 0;
        end_period(avr);
    }
    if (state == cpu_Sleeping) {
        woke = avr->cycle;
    } else if (falls_asleep) { /* the step's time is sleep */
        longest = greater(longest, avr_cycles_to_usec((avr_t *)avr, begun - woke));
    } else {
        busy += (uint32_t)(avr->cycle - begun);
    }
    if (avr->cycle >= period_end) {
        end_period(avr);
    }
}

static uint32_t take(uint32_t *value)
{
    uint32_t taken = *value;

    *value = 0;
    return taken;
}

uint32_t load_meter_take_busiest_us(void)
{
    return take(&busiest);
}

uint32_t load_meter_take_longest_us(void)
{
    return take(&longest);
}
