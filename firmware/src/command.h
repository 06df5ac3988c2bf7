/* What the daemon may command: the frames of docs/spi-frame.md as values. */
#ifndef COMMAND_H
#define COMMAND_H

#include <stdbool.h>
#include <stdint.h>

#include "arm_settings.h"
#include "frame.h"
#include "pose.h"
#include "segment.h"
#include "settings.h"
#include "twist.h"

enum command_kind {
    COMMAND_POLL = 0x00,
    COMMAND_VELOCITY = 0x01,
    COMMAND_PATH = 0x02,
    COMMAND_SEGMENTS = 0x03,
    COMMAND_CLEAR = 0x04,
    COMMAND_CAPTION = 0x05,
    COMMAND_SETTINGS = 0x06,
    COMMAND_ARM_SETTINGS = 0x07,
    COMMAND_ARM_MOVE = 0x08,
    COMMAND_ARM_POLL = 0x09,
};

enum answer {
    ANSWER_NONE = 0,
    ANSWER_DONE = 1,
    ANSWER_QUEUE_FULL = 2,
    ANSWER_STOPPED = 3,
    ANSWER_OUT_OF_RANGE = 4,
    ANSWER_UNKNOWN_KIND = 5,
    ANSWER_NOT_CLEARED = 6,
    ANSWER_NOT_ON_PATH = 7,
    ANSWER_MOVES = 8,
    ANSWER_NO_ARM = 9,
};

enum {
    CAPTION_LENGTH = 20,
    PATH_SEGMENTS = 3, /* in the frame that begins a path, at most */
    MORE_SEGMENTS = 4, /* in one that goes on with it */
};

/* The beginning of a path. */
struct path_start {
    struct pose here; /* of the reference */
    uint16_t pace_q15;
    struct segment_limits limits;
};

/* Segments of a path that follow each other. */
struct path_segments {
    uint16_t path;
    uint16_t first; /* its place on the path, from 0; wraps around */
    bool is_onward;
    uint8_t count;
    struct segment segments[MORE_SEGMENTS];
};

/* Where an arm's joints shall be. */
struct arm_goal {
    int32_t urad[ARM_JOINTS];
    bool is_hand_closed;
    bool is_onward; /* else they shall stand on the way */
};

struct command {
    enum command_kind kind;
    uint8_t sequence;
    union {
        struct twist velocity;
        struct {
            struct path_start start; /* of a new path only */
            struct path_segments more;
        } path;
        struct {
            uint16_t reasons;
            bool by_person;
        } clear;
        char caption[CAPTION_LENGTH];
        struct settings settings;
        struct arm_settings arm_settings;
        struct arm_goal arm_goal;
    } as;
};

/* Reads a good frame. Returns ANSWER_DONE, or why it cannot be obeyed. */
enum answer command_read(struct command *command, const uint8_t frame[FRAME_LENGTH]);

#endif
