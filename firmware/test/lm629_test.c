/* What only the drive with LM629 controllers can do and suffer. */
#include "bench.h"
#include "check.h"
#include "lm629_bench.h"
#include "tests.h"

static void dead_controller_is_told(void)
{
    struct bench bench;

    bench_begin(&bench);
    bench_clear(&bench, STOP_POWER_UP, false);
    lm629_bench_controller(1)->is_dead = true;
    bench_live_polled(&bench, 30);
    CHECK_EQUAL(STOP_DRIVE, bench_status(&bench).stop_reasons);
    CHECK_EQUAL(ANSWER_NOT_CLEARED, bench_clear(&bench, STOP_DRIVE, true));
    lm629_bench_controller(1)->is_dead = false;
    bench_live_polled(&bench, 20);
    CHECK_EQUAL(ANSWER_DONE, bench_clear(&bench, STOP_DRIVE, true));
}

static void no_controller_is_spoken_to_while_it_is_busy(void)
{
    struct bench bench;

    bench_begin(&bench);
    bench_clear(&bench, STOP_POWER_UP, false);
    bench_path(&bench, 1, (struct segment[]){{250000, 1000000, 1000000}}, 1);
    bench_live_polled(&bench, 3000);
    for (int i = 0; i < RIG_WHEELS; i++) {
        CHECK_EQUAL(0, lm629_bench_controller(i)->rudenesses);
    }
}

void lm629_tests(void)
{
    dead_controller_is_told();
    no_controller_is_spoken_to_while_it_is_busy();
}
