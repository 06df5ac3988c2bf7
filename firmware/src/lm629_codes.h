/* Commands and bits of the LM629 (data sheet SNVS781, "User Command Set"). */
#ifndef LM629_CODES_H
#define LM629_CODES_H

enum lm629_command {
    LM629_RESET = 0x00,
    LM629_START = 0x01,            /* STT */
    LM629_UPDATE_FILTER = 0x04,    /* UDF */
    LM629_READ_POSITION = 0x0A,    /* RDRP */
    LM629_LIMIT_AND_STOP = 0x1A,   /* LPES */
    LM629_RESET_INTERRUPTS = 0x1D, /* RSTI */
    LM629_LOAD_FILTER = 0x1E,      /* LFIL */
    LM629_LOAD_TRAJECTORY = 0x1F,  /* LTRJ */
};

enum lm629_status {
    LM629_BUSY = 1 << 0,
    LM629_COMMAND_ERROR = 1 << 1,
    LM629_COMPLETE = 1 << 2,
    LM629_WRAPPED = 1 << 4,
    LM629_POSITION_ERROR = 1 << 5,
    LM629_MOTOR_OFF = 1 << 7,
};

enum lm629_filter_word {
    LM629_HAS_LIMIT = 1 << 0,
    LM629_HAS_DERIVATIVE = 1 << 1,
    LM629_HAS_INTEGRAL = 1 << 2,
    LM629_HAS_PROPORTIONAL = 1 << 3,
};

enum lm629_trajectory_word {
    LM629_HAS_VELOCITY = 1 << 3,
    LM629_HAS_ACCELERATION = 1 << 5,
    LM629_TURN_MOTOR_OFF = 1 << 8,
    LM629_STOP_ABRUPTLY = 1 << 9,
    LM629_VELOCITY_MODE = 1 << 11,
    LM629_FORWARD = 1 << 12,
};

#endif
