/* Range sensors, battery, display, segments: the small parts. */
#include <math.h>
#include <string.h>

#include "angle.h"
#include "battery.h"
#include "brake.h"
#include "check.h"
#include "panel.h"
#include "range.h"
#include "segment.h"
#include "tests.h"

static void take(struct range *range, const uint8_t *bytes, unsigned length)
{
    for (unsigned i = 0; i < length; i++) {
        range_take_byte(range, bytes[i]);
    }
}

/* 250, 800, 1000 mm: 250 = 1 * 128 + 122, 800 = 6 * 128 + 32, 1000 = 7 * 128 + 104 */
static const uint8_t MESSAGE[] = {0xFF, 1, 122, 6, 32, 7, 104, (1 + 122 + 6 + 32 + 7 + 104) & 0x7F};

static void ranges_are_read(void)
{
    struct range range;

    range_begin(&range);
    CHECK_EQUAL(RANGE_SILENT_MM, range.mm[0]);
    take(&range, MESSAGE, sizeof MESSAGE);
    CHECK_EQUAL(250, range.mm[0]);
    CHECK_EQUAL(800, range.mm[1]);
    CHECK_EQUAL(RANGE_NOTHING_MM, range.mm[2]);
}

static void damaged_message_changes_nothing(void)
{
    struct range range;

    range_begin(&range);
    take(&range, MESSAGE, sizeof MESSAGE);
    for (unsigned i = 0; i < sizeof MESSAGE; i++) {
        uint8_t damaged[sizeof MESSAGE];

        memcpy(damaged, MESSAGE, sizeof MESSAGE);
        damaged[i] ^= 0x11;
        take(&range, damaged, sizeof damaged);
        CHECK_EQUAL(250, range.mm[0]);
        CHECK_EQUAL(800, range.mm[1]);
    }
    take(&range, MESSAGE, sizeof MESSAGE);
    CHECK_EQUAL(250, range.mm[0]);
}

static void silence_is_told(void)
{
    struct range range;

    range_begin(&range);
    take(&range, MESSAGE, sizeof MESSAGE);
    for (int ms = 0; ms < RANGE_TIME_OUT_MS; ms++) {
        range_elapse(&range, 1);
    }
    CHECK_EQUAL(250, range.mm[0]);
    range_elapse(&range, 1);
    CHECK_EQUAL(RANGE_SILENT_MM, range.mm[0]);
}

static void battery_is_low_after_a_second(void)
{
    struct battery battery;

    battery_begin(&battery);
    battery_update(&battery, 16000, 1);
    CHECK_EQUAL(16000, battery_mv(&battery));
    for (int ms = 0; ms < 500; ms++) {
        battery_update(&battery, 12000, 1);
    }
    CHECK(!battery_is_low(&battery));
    for (int ms = 0; ms < 600; ms++) {
        battery_update(&battery, 12000, 1);
    }
    CHECK(battery_is_low(&battery));
}

static void panel_shows_state_and_error(void)
{
    static struct robot robot;
    struct panel panel;

    memset(&robot, 0, sizeof robot);
    memcpy(robot.caption, "r1 127.0.0.1:7275   ", CAPTION_LENGTH);
    robot.stop.reasons = STOP_LINK | STOP_EDGE;
    panel_write(&panel, &robot);
    CHECK(memcmp(panel.lines[0], "r1 127.0.0.1:7275   ", PANEL_COLUMNS) == 0);
    CHECK(memcmp(panel.lines[1], "STOPPED: EDGE       ", PANEL_COLUMNS) == 0);
    robot.stop.reasons = STOP_WATCHDOG;
    panel_write(&panel, &robot);
    CHECK(memcmp(panel.lines[1], "STOPPED: WATCHDOG   ", PANEL_COLUMNS) == 0);
    robot.stop.reasons = 0;
    panel_write(&panel, &robot);
    CHECK(memcmp(panel.lines[1], "READY               ", PANEL_COLUMNS) == 0);
}

static double speed(const struct segment_queue *queue)
{
    return segment_queue_twist(queue).vx_um_s * 1e-6;
}

static void reference_covers_its_segments_within_the_limits(void)
{
    static const struct segment segments[] = {
        {250000, 0, 2000000}, {250000, 1000000, 1571000}, {500000, 0, 1000000}, {0, -1500000, 1047000}};
    static const struct pose origin = {0, 0, 0};
    static const struct segment_limits limits = {500, 3000};
    struct segment_queue queue;
    double before = 0;
    int ticks = 0;

    segment_queue_begin(&queue);
    segment_queue_start(&queue, &origin, 0, &limits);
    CHECK_EQUAL(4, segment_queue_add(&queue, segments, 4));
    while (queue.count != 0 && ticks < 2000) {
        segment_queue_advance(&queue, 1U << 15, 10);
        /* 0.5 m/s2, and a jump of 0.15 m/s at a corner */
        CHECK(fabs(speed(&queue) - before) <= 0.5 * 0.010 + 0.15 + 1e-3);
        before = speed(&queue);
        ticks++;
    }
    /* planned 5.618 s; time stretches */
    CHECK(ticks > 562 && ticks < 1000);
    CHECK(segment_queue_is_standing(&queue));
    CHECK_EQUAL(4, queue.driven);
    /* 0.5 m, the quarter circle of 0.25 m, 0.5 m to the left */
    CHECK_NEAR(0.75, pose_um(queue.reference.x_um_q16) * 1e-6, 0.001);
    CHECK_NEAR(0.75, pose_um(queue.reference.y_um_q16) * 1e-6, 0.001);
    CHECK_NEAR((M_PI / 2 - 1.5 * 1.047) * 1e6, angle_urad(queue.reference.heading), 1000);
}

static void wheel_that_does_not_slow_down_is_not_reversed_for_ever(void)
{
    struct brake brake;

    brake_begin_reversing(&brake, 1, 0, 5000, 10296);
    /* at 5 counts a millisecond */
    CHECK_EQUAL(150 * 16, brake_end_ms_q4(&brake, 1, 5 * 20, 20 * 16));
    CHECK_EQUAL(150 * 16, brake_end_ms_q4(&brake, 1, 5 * 149, 149 * 16));
    CHECK(!brake_has_stopped(&brake, 1, 5 * 149, 149 * 16));
    CHECK(brake_has_stopped(&brake, 1, 5 * 150, 150 * 16));
}

static void end_of_braking_is_foreseen(void)
{
    struct brake brake;

    brake_begin_reversing(&brake, 1, 700, -8000, 10296);
    for (uint16_t ms = 12; ms < 30; ms += 2) {
        /* T = 0.04 s: 23.0 ms, 0.04 ln(1 + 8000/10296) */
        double travelled = 0.04 * (8000 + 10296) * (1 - exp(-ms / 40.0)) - 10.296 * ms;
        int32_t counts = (int32_t)floor(700 - travelled);

        CHECK_NEAR(23.0, brake_end_ms_q4(&brake, 1, counts, (uint16_t)(ms * 16)) / 16.0, 1.5);
        CHECK_EQUAL(ms >= 23, brake_has_stopped(&brake, 1, counts, (uint16_t)(ms * 16)));
    }
}

void part_tests(void)
{
    ranges_are_read();
    damaged_message_changes_nothing();
    silence_is_told();
    battery_is_low_after_a_second();
    wheel_that_does_not_slow_down_is_not_reversed_for_ever();
    end_of_braking_is_foreseen();
    panel_shows_state_and_error();
    reference_covers_its_segments_within_the_limits();
}
