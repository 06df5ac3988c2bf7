#ifndef LM629_BENCH_H
#define LM629_BENCH_H

#include "lm629_model.h"

struct lm629_model *lm629_bench_controller(int wheel);

#endif
