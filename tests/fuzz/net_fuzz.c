/* Any bytes as the tables of a system of ropes (nodes, ropes and types, a line of "=" between
 * them): refused with words that name the table, or a system whose solution, if there is one, is in
 * balance. */
#include "form/netfiles.h"
#include "fuzz.h"

#include <math.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

/* A file of memory with these bytes; its path to path. */
static int file_of(const char *text, size_t size, char path[64])
{
    int fd = memfd_create("fuzz", 0);

    check(fd >= 0 && write(fd, text, size) == (ssize_t)size);
    snprintf(path, 64, "/proc/self/fd/%d", fd);
    return fd;
}

static void solve(struct system *p)
{
    struct net_options o = {.tolerance = 5e-10, .steps = 60};
    struct net_state s;
    int node;

    for (int r = 0; r < p->net.m; r++) /* long chains take their time */
        if (p->net.rope[r].rope.elements > 50)
            return;
    if (net_solve(&p->net, &o, &s) == SW_OK)
        check(net_unbalance(p, &s, &node) <= 1e-8);
    net_state_free(&s);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const mark = "\n=\n";
    struct system_case c = {.gravity = 9.81, .depth = NAN, .elements = 3, .tolerance = 5e-10, .steps = 60};
    char *const to[3] = {c.nodes, c.ropes, c.types};
    char *text = calloc(size + 1, 1), *at = text;
    int fd[3], parts = 0;
    struct system p;
    struct why why = {""};

    check(text);
    memcpy(text, data, size);
    while (parts < 3) {
        size_t rest = size - (size_t)(at - text);
        char *end = parts < 2 ? memmem(at, rest, mark, 3) : NULL;
        size_t length = end ? (size_t)(end - at) + 1 : rest;

        fd[parts] = file_of(at, length, to[parts]);
        at += end ? length + 2 : length;
        parts++;
    }
    err_level(1, 0);
    if (system_load("", &c, &p, &why) == SW_OK) {
        check(p.net.m > 0 && p.net.n > 0);
        if (p.net.n < 30 && p.net.m < 60)
            solve(&p);
        system_free(&p);
    } else {
        check(strncmp(why.text, "/proc/", 6) == 0 || strstr(why.text, "cannot be"));
    }
    for (int i = 0; i < 3; i++)
        close(fd[i]);
    free(text);
    return 0;
}
