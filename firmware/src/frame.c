#include "frame.h"

#include <string.h>

#include "bytes.h"
#include "crc16.h"

void frame_seal(uint8_t bytes[FRAME_LENGTH], uint8_t kind, uint8_t sequence)
{
    bytes[0] = FRAME_SYNC_1;
    bytes[1] = FRAME_SYNC_2;
    bytes[FRAME_KIND] = kind;
    bytes[FRAME_SEQUENCE] = sequence;
    put_u16(bytes + FRAME_CRC, crc16(bytes, FRAME_CRC));
}

void frame_parser_begin(struct frame_parser *parser)
{
    parser->length = 0;
    parser->is_searching = false;
    parser->bad = 0;
}

static void count_bad(struct frame_parser *parser)
{
    if (parser->bad != UINT16_MAX) {
        parser->bad++;
    }
}

static bool begins_frame(const uint8_t *bytes, uint8_t length)
{
    return bytes[0] == FRAME_SYNC_1 && (length < 2 || bytes[1] == FRAME_SYNC_2);
}

/* Drops bytes from the front until what is left can be the beginning of a frame. */
static void resynchronise(struct frame_parser *parser)
{
    uint8_t start = 0;

    while (start < parser->length &&
           !begins_frame(parser->bytes + start, (uint8_t)(parser->length - start))) {
        start++;
    }
    parser->length = (uint8_t)(parser->length - start);
    memmove(parser->bytes, parser->bytes + start, parser->length);
}

/* What the parser took for a frame is none; one that begins within it may still be good. */
static void reject(struct frame_parser *parser)
{
    if (!parser->is_searching) {
        parser->is_searching = true;
        count_bad(parser);
    }
    parser->bytes[0] = 0;
    resynchronise(parser);
}

bool frame_parser_add(struct frame_parser *parser, uint8_t byte)
{
    if (parser->length == FRAME_LENGTH) {
        parser->length = 0;
    }
    parser->bytes[parser->length++] = byte;
    if (!begins_frame(parser->bytes, parser->length)) {
        reject(parser);
        return false;
    }
    if (parser->length < FRAME_LENGTH) {
        return false;
    }
    if (get_u16(parser->bytes + FRAME_CRC) != crc16(parser->bytes, FRAME_CRC)) {
        reject(parser);
        return false;
    }
    parser->is_searching = false;
    return true;
}

void frame_parser_pause(struct frame_parser *parser)
{
    bool is_half = parser->length != 0 && parser->length != FRAME_LENGTH;

    if (is_half && !parser->is_searching) {
        count_bad(parser);
    }
    parser->length = 0;
    parser->is_searching = false;
}
