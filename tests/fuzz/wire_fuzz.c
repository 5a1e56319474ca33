/* Any bytes as the tables of a structure of wires (nodes, elements, sections, supports, loads and
 * springs, a line of "=" between them): refused with words that name the table, or a structure
 * whose equilibrium, if one is found, leaves free nodes in balance. */
#include "form/wirefiles.h"
#include "fuzz.h"

#include <math.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#define TABLES 6

/* A file of memory with these bytes; its path to path. */
static int file_of(const char *text, size_t size, char path[64])
{
    int fd = memfd_create("fuzz", 0);

    check(fd >= 0 && write(fd, text, size) == (ssize_t)size);
    snprintf(path, 64, "/proc/self/fd/%d", fd);
    return fd;
}

static void solve(struct wire *p)
{
    const struct follow_options o = {
        .tolerance = 1e-8, .parts = 1, .steps = 3, .iterations = 8, .watch = -1};
    struct frame_state s;
    struct frame_work w;
    struct follow_path path;

    if (frame_state_new(&p->frame, &s) != SW_OK)
        return;
    if (frame_work_new(&p->frame, &w) == SW_OK) {
        if (follow(&p->frame, &o, &s, &w, &path) == SW_OK) {
            check(path.n > 0 && path.step[path.n - 1].residual <= 1e-8);
            for (int i = 0; i < 3 * p->frame.n; i++)
                check(isfinite(s.x[i]));
        }
        follow_path_free(&path);
        frame_work_free(&w);
    }
    frame_state_free(&s);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const mark = "\n=\n";
    struct wire_case c = {.gravity = {0, 0, -1}, .divide = 1, .largest_angle = 30, .points = 2};
    char *const to[TABLES] = {c.nodes, c.elements, c.sections, c.supports, c.loads, c.springs};
    char *text = calloc(size + 1, 1), *at = text;
    int fd[TABLES], parts = 0;
    struct wire p;
    struct why why = {""};

    check(text);
    memcpy(text, data, size);
    for (; parts < TABLES && at; parts++) {
        size_t rest = size - (size_t)(at - text);
        char *end = parts < TABLES - 1 ? memmem(at, rest, mark, 3) : NULL;
        size_t length = end ? (size_t)(end - at) + 1 : rest;

        fd[parts] = file_of(at, length, to[parts]);
        at = end ? at + length + 2 : NULL;
    }
    err_level(1, 0);
    if (parts >= 3 && wire_load("", &c, &p, &why) == SW_OK) {
        check(p.frame.beams > 0 && p.frame.n > 1);
        if (p.frame.beams < 40 && p.frame.springs < 10 && p.frame.stages < 4)
            solve(&p);
        wire_free(&p);
    } else if (parts >= 3) {
        check(strncmp(why.text, "/proc/", 6) == 0 || strstr(why.text, "cannot be"));
    }
    for (int i = 0; i < parts; i++)
        close(fd[i]);
    free(text);
    return 0;
}
