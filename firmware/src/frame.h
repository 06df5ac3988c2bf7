/* The frame of docs/spi-frame.md, and how it is found in a stream of bytes. */
#ifndef FRAME_H
#define FRAME_H

#include <stdbool.h>
#include <stdint.h>

enum {
    FRAME_LENGTH = 64,
    FRAME_SYNC_1 = 0xA5,
    FRAME_SYNC_2 = 0x5A,
    FRAME_KIND = 2,
    FRAME_SEQUENCE = 3,
    FRAME_PAYLOAD = 4,
    FRAME_CRC = 62,
};

/* Puts sync, kind, sequence and CRC around a payload. */
void frame_seal(uint8_t bytes[FRAME_LENGTH], uint8_t kind, uint8_t sequence);

struct frame_parser {
    uint8_t bytes[FRAME_LENGTH];
    uint8_t length;
    bool is_searching;
    uint16_t bad; /* frames; stays at 65535 */
};

void frame_parser_begin(struct frame_parser *parser);

/* Returns whether a whole good frame lies in parser->bytes, until the next byte is taken. */
bool frame_parser_add(struct frame_parser *parser, uint8_t byte);

/* The sender made a pause: what is half received will never be whole. */
void frame_parser_pause(struct frame_parser *parser);

#endif
