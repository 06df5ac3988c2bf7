/* Frames in a stream of bytes: good ones, bad ones, and a million bytes of neither. */
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "command.h"
#include "crc16.h"
#include "frame.h"
#include "tests.h"

enum { FUZZ_INPUTS = 1000000 };

static struct frame_parser parser;

static void make(uint8_t frame[FRAME_LENGTH], uint8_t sequence)
{
    memset(frame, 0, FRAME_LENGTH);
    frame_seal(frame, COMMAND_CAPTION, sequence);
}

static unsigned take(const uint8_t *bytes, unsigned length)
{
    unsigned frames = 0;

    for (unsigned i = 0; i < length; i++) {
        frames += frame_parser_add(&parser, bytes[i]);
    }
    return frames;
}

static void crc_is_the_published_one(void)
{
    /* the check value of CRC-16/CCITT-FALSE */
    CHECK_EQUAL(0x29B1, crc16((const uint8_t *)"123456789", 9));
}

static void frames_one_after_another_are_found(void)
{
    uint8_t frames[3][FRAME_LENGTH];

    frame_parser_begin(&parser);
    for (uint8_t i = 0; i < 3; i++) {
        make(frames[i], i);
    }
    CHECK_EQUAL(3, take(frames[0], sizeof frames));
    CHECK_EQUAL(2, parser.bytes[FRAME_SEQUENCE]);
    CHECK_EQUAL(0, parser.bad);
}

static void every_flipped_bit_is_noticed(void)
{
    uint8_t frame[FRAME_LENGTH];

    for (unsigned bit = 0; bit < 8 * FRAME_LENGTH; bit++) {
        frame_parser_begin(&parser);
        make(frame, 7);
        frame[bit / 8] ^= (uint8_t)(1U << bit % 8);
        CHECK_EQUAL(0, take(frame, FRAME_LENGTH));
        frame_parser_pause(&parser);
        CHECK_EQUAL(1, parser.bad);
        make(frame, 8);
        CHECK_EQUAL(1, take(frame, FRAME_LENGTH));
    }
}

static void lost_byte_costs_one_frame(void)
{
    uint8_t frame[FRAME_LENGTH];

    make(frame, 1);
    for (unsigned lost = 0; lost < FRAME_LENGTH; lost++) {
        frame_parser_begin(&parser);
        CHECK_EQUAL(0, take(frame, lost) + take(frame + lost + 1, FRAME_LENGTH - lost - 1));
        /* no pause: the next frame is found by its sync */
        CHECK_EQUAL(1, take(frame, FRAME_LENGTH));
        CHECK_EQUAL(1, parser.bad);
    }
}

static void pause_ends_half_a_frame(void)
{
    uint8_t frame[FRAME_LENGTH];

    frame_parser_begin(&parser);
    make(frame, 1);
    CHECK_EQUAL(0, take(frame, 30));
    frame_parser_pause(&parser);
    CHECK_EQUAL(1, parser.bad);
    frame_parser_pause(&parser);
    CHECK_EQUAL(1, parser.bad);
    CHECK_EQUAL(1, take(frame, FRAME_LENGTH));
}

/* Deterministic: the same numbers every time (xorshift32). */
static uint32_t random_number(void)
{
    static uint32_t state = 2463534242U;

    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state;
}

static void damage(uint8_t *frame)
{
    unsigned changes = random_number() % 4;

    for (unsigned i = 0; i < changes; i++) {
        frame[random_number() % FRAME_LENGTH] = (uint8_t)random_number();
    }
}

static bool is_good(const uint8_t *frame)
{
    uint16_t crc = crc16(frame, FRAME_CRC);

    return frame[0] == FRAME_SYNC_1 && frame[1] == FRAME_SYNC_2 &&
           frame[FRAME_CRC] == (crc & 0xFF) && frame[FRAME_CRC + 1] == crc >> 8;
}

/* Frames, damaged or not, cut short or after noise; what comes out must be good and readable. */
static void a_million_inputs_do_no_harm(void)
{
    struct command command;
    uint8_t frame[FRAME_LENGTH];
    unsigned good = 0;

    frame_parser_begin(&parser);
    for (unsigned input = 0; input < FUZZ_INPUTS; input++) {
        unsigned length = random_number() % 8 == 0 ? random_number() % FRAME_LENGTH : FRAME_LENGTH;

        for (unsigned i = 0; i < FRAME_LENGTH; i++) {
            frame[i] = (uint8_t)random_number();
        }
        frame_seal(frame, (uint8_t)(random_number() % 8), (uint8_t)input);
        damage(frame);
        for (unsigned i = 0; i < length; i++) {
            if (frame_parser_add(&parser, frame[i])) {
                good++;
                if (!is_good(parser.bytes)) {
                    CHECK(!"a bad frame was taken for a good one");
                }
                (void)command_read(&command, parser.bytes);
            }
        }
        if (random_number() % 16 == 0) {
            frame_parser_pause(&parser);
        }
    }
    /* a quarter has no damage, 7/8 of it whole length, and most of these are found */
    CHECK(good > FUZZ_INPUTS / 6);
    frame_parser_pause(&parser);
    make(frame, 1);
    CHECK_EQUAL(1, take(frame, FRAME_LENGTH));
}

void frame_tests(void)
{
    crc_is_the_published_one();
    frames_one_after_another_are_found();
    every_flipped_bit_is_noticed();
    lost_byte_costs_one_frame();
    pause_ends_half_a_frame();
    a_million_inputs_do_no_harm();
}
