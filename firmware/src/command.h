/* What the daemon may command: the frames of docs/spi-frame.md as values. */
#ifndef COMMAND_H
#define COMMAND_H

#include <stdbool.h>
#include <stdint.h>

#include "frame.h"
#include "segment.h"
#include "twist.h"

enum command_kind {
    COMMAND_POLL = 0x00,
    COMMAND_VELOCITY = 0x01,
    COMMAND_SEGMENT = 0x02,
    COMMAND_HALT = 0x03,
    COMMAND_CLEAR = 0x04,
    COMMAND_CAPTION = 0x05,
};

enum answer {
    ANSWER_NONE = 0,
    ANSWER_DONE = 1,
    ANSWER_QUEUE_FULL = 2,
    ANSWER_STOPPED = 3,
    ANSWER_OUT_OF_RANGE = 4,
    ANSWER_UNKNOWN_KIND = 5,
    ANSWER_NOT_CLEARED = 6,
};

enum { CAPTION_LENGTH = 20 };

struct command {
    enum command_kind kind;
    uint8_t sequence;
    union {
        struct twist velocity;
        struct segment segment;
        struct {
            uint16_t reasons;
            bool by_person;
        } clear;
        char caption[CAPTION_LENGTH];
    } as;
};

/* Reads a good frame. Returns ANSWER_DONE, or why it cannot be obeyed. */
enum answer command_read(struct command *command, const uint8_t frame[FRAME_LENGTH]);

#endif
