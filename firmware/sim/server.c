#include "server.h"

#include <errno.h>
#include <poll.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <time.h>
#include <unistd.h>

#include "bytes.h"
#include "chip.h"
#include "world_state.h"

enum {
    MOST_CLIENTS = 8,
    MOST_BYTES = 1024, /* of one exchange, or of a line */
    HEADER = 7,        /* 'X', us, length */
    MOST_US = 60000000,
    STEP_MS = 5,       /* of the wall clock */
};

struct client {
    int socket;
    bool owns_time;
    uint8_t request[HEADER + MOST_BYTES];
    size_t length;
};

static struct client clients[MOST_CLIENTS];
static int client_count;

static bool send_all(int socket, const void *bytes, size_t length)
{
    const uint8_t *next = bytes;

    while (length > 0) {
        ssize_t sent = send(socket, next, length, MSG_NOSIGNAL);

        if (sent <= 0) {
            return false;
        }
        next += sent;
        length -= (size_t)sent;
    }
    return true;
}

static void drop(int index)
{
    close(clients[index].socket);
    clients[index] = clients[--client_count];
}

static void forget_request(struct client *client, size_t length)
{
    client->length -= length;
    memmove(client->request, client->request + length, client->length);
}

/* Each returns false when the connection is to be ended. */

static bool exchange(struct client *client, bool *is_whole)
{
    uint32_t us;
    uint16_t length;

    *is_whole = false;
    if (client->length < HEADER) {
        return true;
    }
    us = get_u32(client->request + 1);
    length = get_u16(client->request + 5);
    if (us > MOST_US || length > MOST_BYTES) {
        return false;
    }
    if (client->length < (size_t)HEADER + length) {
        return true;
    }
    *is_whole = true;
    client->owns_time = true;
    chip_run_us(us > chip_exchange_us(length) ? us - chip_exchange_us(length) : 0);
    if (length == 0) {
        bool sent = send_all(client->socket, "", 1);

        forget_request(client, HEADER);
        return sent;
    }
    chip_exchange(client->request + HEADER, length);
    if (!send_all(client->socket, client->request + HEADER, length)) {
        return false;
    }
    forget_request(client, (size_t)HEADER + length);
    return true;
}

static bool tell(struct client *client, bool *is_whole)
{
    char line[MOST_BYTES];

    *is_whole = true;
    forget_request(client, 1);
    world_state_write(line, sizeof line);
    return send_all(client->socket, line, strlen(line));
}

static bool change(struct client *client, bool *is_whole)
{
    uint8_t *end = memchr(client->request, '\n', client->length);
    bool is_understood;

    *is_whole = end != NULL;
    if (end == NULL) {
        return client->length < sizeof client->request;
    }
    *end = '\0';
    is_understood = world_state_change((const char *)client->request + 1);
    forget_request(client, (size_t)(end + 1 - client->request));
    return is_understood ? send_all(client->socket, "ok\n", 3)
                         : send_all(client->socket, "not understood\n", 15);
}

static bool answer(struct client *client)
{
    bool is_whole = true;
    bool is_good = true;

    while (is_whole && is_good && client->length > 0) {
        switch (client->request[0]) {
        case 'X':
            is_good = exchange(client, &is_whole);
            break;
        case 'Q':
            is_good = tell(client, &is_whole);
            break;
        case 'S':
            is_good = change(client, &is_whole);
            break;
        default:
            is_good = false;
        }
    }
    return is_good;
}

static bool receive(struct client *client)
{
    ssize_t length = recv(client->socket, client->request + client->length,
                          sizeof client->request - client->length, 0);

    if (length <= 0) {
        return false;
    }
    client->length += (size_t)length;
    return answer(client);
}

static void accept_client(int listener)
{
    int socket = accept(listener, NULL, NULL);

    if (socket < 0) {
        return;
    }
    if (client_count == MOST_CLIENTS) {
        close(socket);
        return;
    }
    clients[client_count] = (struct client){.socket = socket};
    client_count++;
}

static bool is_time_owned(void)
{
    for (int i = 0; i < client_count; i++) {
        if (clients[i].owns_time) {
            return true;
        }
    }
    return false;
}

static void serve(int listener, int wait_ms)
{
    struct pollfd sockets[MOST_CLIENTS + 1] = {{.fd = listener, .events = POLLIN}};
    int count = client_count;

    for (int i = 0; i < count; i++) {
        sockets[i + 1] = (struct pollfd){.fd = clients[i].socket, .events = POLLIN};
    }
    if (poll(sockets, (nfds_t)(count + 1), wait_ms) <= 0) {
        return;
    }
    for (int i = count - 1; i >= 0; i--) {
        if (sockets[i + 1].revents != 0 && !receive(&clients[i])) {
            drop(i);
        }
    }
    if (sockets[0].revents != 0) {
        accept_client(listener);
    }
}

static uint64_t wall_us(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * 1000000U + (uint64_t)now.tv_nsec / 1000U;
}

static int listen_at(const char *path)
{
    struct sockaddr_un address = {.sun_family = AF_UNIX};
    int listener = socket(AF_UNIX, SOCK_STREAM, 0);

    if (strlen(path) >= sizeof address.sun_path) {
        errno = ENAMETOOLONG;
        return -1;
    }
    strcpy(address.sun_path, path);
    unlink(path);
    if (listener < 0 || bind(listener, (struct sockaddr *)&address, sizeof address) != 0 ||
        listen(listener, MOST_CLIENTS) != 0) {
        return -1;
    }
    return listener;
}

int server_run(const char *socket_path)
{
    int listener = listen_at(socket_path);
    uint64_t before = wall_us();

    if (listener < 0) {
        fprintf(stderr, "toqa-sim: cannot listen at %s: %s.\n", socket_path, strerror(errno));
        return 1;
    }
    printf("listening at %s\n", socket_path);
    fflush(stdout);
    for (;;) {
        uint64_t now;

        serve(listener, is_time_owned() ? -1 : STEP_MS);
        now = wall_us();
        if (!is_time_owned()) {
            uint64_t passed = now - before;

            chip_run_us(passed > MOST_US ? MOST_US : (uint32_t)passed);
        }
        before = now;
    }
}
