/* Three LM629 on the chip's bus, one for each motor. */
#ifndef LM629_BOARD_H
#define LM629_BOARD_H

#include "drive_model.h"
#include "lm629_model.h"

extern const struct drive_model lm629_board;

/* RIG_WHEELS of them; without motors where the chip has another drive. */
struct lm629_model *lm629_board_controllers(void);

#endif
