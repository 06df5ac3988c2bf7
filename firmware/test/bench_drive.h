/* The hardware under the drive that is linked: of the bench that was begun last. */
#ifndef BENCH_DRIVE_H
#define BENCH_DRIVE_H

#include "rig.h"

/* Seconds: a sample of the LM629. */
#define BENCH_DRIVE_SAMPLE (2048 / 6e6)

void bench_drive_begin(struct rig *rig);

/* Turns the motors for BENCH_DRIVE_SAMPLE. */
void bench_drive_sample(void);

#endif
