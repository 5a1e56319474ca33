/* Any bytes as a mooring deck: refused with words that name the file, or a system; written, it is
 * read back as a system of as many nodes and ropes, at the same places. */
#include "form/deck.h"
#include "fuzz.h"

#include <math.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

static const char *const beginnings[] = {"/proc/", "no deck", "memory ran", "--set", "[environ"};

/* A file of memory with these bytes; its path to path. */
static int file_of(const uint8_t *data, size_t size, char path[64])
{
    int fd = memfd_create("fuzz", 0);

    check(fd >= 0 && write(fd, data, size) == (ssize_t)size);
    snprintf(path, 64, "/proc/self/fd/%d", fd);
    return fd;
}

/* The case of a deck at path with a depth where it has none, and its system. */
static enum status load(const char *path, struct system *p, struct why *why)
{
    struct ini ini;
    struct system_case c;
    enum status s = deck_sections(path, &ini, why);

    if (s == SW_OK)
        s = system_case_take(&ini, &c, why);
    ini_free(&ini);
    if (s != SW_OK)
        return s;
    c.is_deck = 1;
    c.depth = isnan(c.depth) ? 250 : c.depth;
    return system_load(path, &c, p, why);
}

static void judge_why(const struct why *why)
{
    for (size_t i = 0; i < sizeof beginnings / sizeof *beginnings; i++)
        if (strncmp(why->text, beginnings[i], strlen(beginnings[i])) == 0)
            return;
    fprintf(stderr, "%s\n", why->text);
    check(0);
}

/* Write the system as if it were solved where it stands, and read it back. */
static void turn_round(struct system *p)
{
    struct net_state s = {.x = calloc(3 * (size_t)p->net.n + 1, sizeof *s.x),
                          .t = calloc(3 * (size_t)p->net.m + 1, sizeof *s.t)};
    char *text = NULL;
    size_t size = 0;
    struct out o = {.f = open_memstream(&text, &size)};
    struct system again;
    struct why why = {""};
    char path[64];
    int fd;
    enum status status;

    check(s.x && s.t && o.f);
    for (int i = 0; i < 3 * p->net.n; i++)
        s.x[i] = isnan(p->net.node[i / 3].x[i % 3]) ? 0 : p->net.node[i / 3].x[i % 3];
    status = deck_write(p, &s, &o, &why);
    fclose(o.f);
    if (status != SW_OK) {
        judge_why(&why);
        check(size == 0);
    } else {
        fd = file_of((const uint8_t *)text, size, path);
        status = load(path, &again, &why);
        if (status == SW_OK) {
            check(again.net.n == p->net.n && again.net.m == p->net.m);
            for (int i = 0; i < 3 * p->net.n; i++)
                check(fabs(again.net.node[i / 3].x[i % 3] - s.x[i]) <= 1e-9 * (1 + fabs(s.x[i])) ||
                      p->net.node[i / 3].body > 0);
            system_free(&again);
        } else {
            judge_why(&why); /* mass or volume out of range by the load that they stand for */
        }
        close(fd);
    }
    free(text);
    free(s.x);
    free(s.t);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct system p;
    struct why why = {""};
    char path[64];
    int fd = file_of(data, size, path), is_deck;

    err_level(1, 0);
    check(deck_recognize(path, &is_deck, &why) == SW_OK);
    if (load(path, &p, &why) == SW_OK) {
        check(p.net.m > 0 && p.net.n > 0);
        if (p.net.n < 100)
            turn_round(&p);
        system_free(&p);
    } else {
        judge_why(&why);
    }
    close(fd);
    return 0;
}
