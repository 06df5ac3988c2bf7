/*
 * The simulated microcontroller behind a Unix socket. A request is a byte and what follows it;
 * numbers are little-endian.
 *
 *   'X' uint32 us, uint16 length, bytes    lets time pass, in the end of which it exchanges bytes
 *                                          over the SPI; answered by as many bytes. Length 0: time
 *                                          passes only, answered by a byte
 *   'Q'                                    answered by a line of name=value pairs: the true state
 *   'S' text up to a line feed             changes the surroundings (see docs/firmware.md);
 *                                          answered by a line, "ok" or what is wrong
 *
 * While a connection that has sent an 'X' is open, time is its own; else it is the wall clock's.
 */
#ifndef SERVER_H
#define SERVER_H

/* Serves until a signal ends the program. Returns the exit code when it cannot. */
int server_run(const char *socket_path);

#endif
