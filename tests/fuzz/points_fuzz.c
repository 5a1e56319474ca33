/* Fuzz target: tables of parameter points.  A table that is read has a case or a reason for each
 * point, and prints as many cells as it has columns. */
#include "fuzz.h"

#include "form/points.h"

#include <string.h>
#include <unistd.h>

static const char text[] = "[cable]\nunstressed_length = 100.4\nmass_per_length = 0.7\n"
                           "axial_stiffness = 1.3e7\n[supports]\nspan = 100.5\n[mesh]\n"
                           "elements = 2\n[motion]\namplitude = 0.05 0 0\nomega = 9\n";

/* The bytes as a file. */
static void put(const char *path, const void *data, size_t size)
{
    FILE *f = fopen(path, "wb");

    check(f && fwrite(data, 1, size, f) == size && fclose(f) == 0);
}

/* Commas outside of quotes in what is printed. */
static int separators(const struct points *p, int i)
{
    char *line = NULL;
    size_t length;
    struct out o = {.slot = -1, .f = open_memstream(&line, &length)};
    int n = 0, quoted = 0;

    check(o.f != NULL);
    points_print(p, i, &o);
    fclose(o.f);
    for (size_t k = 0; k < length; k++) {
        quoted ^= line[k] == '"';
        n += line[k] == ',' && !quoted;
    }
    free(line);
    return n;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char table[64], path[64];
    struct opt_list sets = {NULL, 0};
    struct points p;
    struct why why = {""};

    snprintf(table, sizeof table, "/tmp/points-fuzz-%d.csv", (int)getpid());
    snprintf(path, sizeof path, "/tmp/points-fuzz-%d.ini", (int)getpid());
    put(table, data, size);
    put(path, text, sizeof text - 1);
    err_level(1, 0);
    if (points_read(table, path, &sets, &p, &why) == SW_OK) {
        for (int i = 0; i < p.n; i++) {
            struct cable_case c;
            enum status s;

            why.text[0] = '\0';
            s = points_case(&p, i, &c, &why);
            check((s == SW_OK) == (why.text[0] == '\0'));
            check(s == SW_OK || strncmp(why.text, table, strlen(table)) == 0);
            check(separators(&p, i) == p.n_columns - 1);
            if (s == SW_OK)
                case_free(&c);
        }
        points_free(&p);
    } else {
        check(why.text[0] != '\0');
    }
    remove(table);
    remove(path);
    return 0;
}
