#include "stop.h"

static const uint16_t CLEARED_BY_DAEMON = STOP_POWER_UP | STOP_LINK;

void stop_begin(struct stop *stop, enum stop_reason reason)
{
    stop->reasons = (uint16_t)reason;
    stop->causes = 0;
}

void stop_set_cause(struct stop *stop, enum stop_reason reason, bool is_present)
{
    if (is_present) {
        stop->causes = (uint16_t)(stop->causes | reason);
        stop->reasons = (uint16_t)(stop->reasons | reason);
    } else {
        stop->causes = (uint16_t)(stop->causes & ~(unsigned)reason);
    }
}

bool stop_clear(struct stop *stop, uint16_t reasons, bool by_person)
{
    unsigned cleared = reasons & ~(unsigned)stop->causes;

    if (!by_person) {
        cleared &= CLEARED_BY_DAEMON;
    }
    stop->reasons = (uint16_t)(stop->reasons & ~cleared);
    return (stop->reasons & reasons) == 0;
}

const char *stop_text(uint16_t reasons)
{
    static const struct {
        uint16_t reason;
        char text[sizeof "WATCHDOG"];
    } by_severity[STOP_REASONS] = {
        {STOP_DRIVE, "DRIVE"},     {STOP_STALL, "STALL"},       {STOP_HEAT, "HEAT"},
        {STOP_EDGE, "EDGE"},       {STOP_SWITCH, "SWITCH"},     {STOP_BATTERY, "BATTERY"},
        {STOP_WATCHDOG, "WATCHDOG"}, {STOP_LINK, "LINK"},       {STOP_POWER_UP, "POWER-UP"},
    };

    for (uint8_t i = 0; i < STOP_REASONS; i++) {
        if ((reasons & by_severity[i].reason) != 0) {
            return by_severity[i].text;
        }
    }
    return "";
}
