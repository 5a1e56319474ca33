/* Any bytes as the tables of a system of ropes: nodes, ropes, types, and where there are more of
 * them, current, bed and bodies, a line of "=" between two; a digit before them all chooses a plane
 * bed, its slope and friction, and how drag is renewed.  Refused with words that name the table, or
 * a system whose solution, if there is one, is in balance. */
#include "form/netfiles.h"
#include "fuzz.h"

#include <math.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

enum { NEEDED = 3, TABLES = 6 };

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
    struct net_options o = {.split = 5,
                            .hold = p->c.drag == DRAG_HOLD,
                            .tolerance = p->c.tolerance,
                            .steps = p->c.steps};
    struct net_state s;
    int node;

    for (int r = 0; r < p->net.m; r++) /* long chains take their time */
        if (p->net.rope[r].rope.elements > 50)
            return;
    if (net_settle(&p->net, &o, &s) == SW_OK)
        check(net_unbalance(p, &s, &node) <= 1e-8);
    net_state_free(&s);
}

/* Bits 1, 2, 4, 8: bed, slope, friction, drag held. */
static void choose_sea(int bits, struct system_case *c)
{
    if (bits & 1)
        c->depth = 50;
    if (bits & 2 && bits & 1)
        memcpy(c->slope, (const double[]){0.1, -0.05}, sizeof c->slope);
    c->friction = bits & 4 ? 0.7 : NAN;
    c->drag = bits & 8 ? DRAG_HOLD : DRAG_RENEW;
}

/* Small ones in reasonable time: rounds of renewal make those in the sea slower. */
static int is_small(const struct system *p)
{
    return p->net.sea ? p->net.n < 10 && p->net.m < 10 && p->net.bodies < 3
                      : p->net.n < 30 && p->net.m < 60 && p->net.bodies < 3;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const mark = "\n=\n";
    struct system_case c = {.gravity = 9.81,
                            .density = 1025,
                            .depth = NAN,
                            .friction = NAN,
                            .elements = 3,
                            .tolerance = 5e-10,
                            .steps = 60};
    char *const to[TABLES] = {c.nodes, c.ropes, c.types, c.current, c.bed, c.bodies};
    char *text = calloc(size + 1, 1), *at = text;
    int fd[TABLES], parts = 0;
    struct system p;
    struct why why = {""};

    check(text);
    memcpy(text, data, size);
    if (size > 0 && *at >= '0' && *at <= '9')
        choose_sea(*at++ - '0', &c);
    else
        c.density = 0;
    for (int more = 1; parts < TABLES && (more || parts < NEEDED); parts++) {
        size_t rest = size - (size_t)(at - text);
        char *end = memmem(at, rest, mark, strlen(mark));
        size_t length = end ? (size_t)(end - at) + 1 : rest;

        fd[parts] = file_of(at, length, to[parts]);
        more = end != NULL;
        at += end ? length + 2 : length;
    }
    err_level(1, 0);
    if (system_load("", &c, &p, &why) == SW_OK) {
        check(p.net.m > 0 && p.net.n > 0);
        if (is_small(&p))
            solve(&p);
        system_free(&p);
    } else {
        check(strncmp(why.text, "/proc/", 6) == 0 || strstr(why.text, "cannot be") ||
              strstr(why.text, "either depth or bed"));
    }
    for (int i = 0; i < parts; i++)
        close(fd[i]);
    free(text);
    return 0;
}
