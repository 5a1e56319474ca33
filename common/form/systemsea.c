/* Bed and current of a system of ropes. */
#include "form/systemtable.h"
#include "num/mem.h"
#include "num/pi.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct sheet_column bed_column[3] = {{"x_m", 1}, {"y_m", 1}, {"z_m", 1}};
static const struct sheet_column current_column[3] = {{"z_m", 1},
                                                      {"speed_m_s", 1},
                                                      {"direction_deg", 1}};

/* value to the ascending ones in list (n), if it is not there; its place. */
static int place_of(double value, double *list, int *n)
{
    int low = 0, high = *n;

    while (low < high) {
        int middle = low + (high - low) / 2;

        if (list[middle] < value)
            low = middle + 1;
        else
            high = middle;
    }
    if (low < *n && list[low] == value)
        return low;
    memmove(list + low + 1, list + low, (size_t)(*n - low) * sizeof *list);
    list[low] = value;
    (*n)++;
    return low;
}

/* The points of t, in any order, to a grid: x, y, then z; every x with every y. */
static enum status take_grid(const struct sheet *t, struct system *p, struct why *why)
{
    struct bed *bed = &p->sea.bed;
    double *x, *y, *z, point[3];
    enum status s = SW_OK;

    if (t->n == 0)
        return fail(why, SW_FORMAT, "%.400s: has no points", t->name);
    p->bed_table = mem_doubles(3 * (size_t)t->n);
    if (!p->bed_table)
        return fail_plain(why, SW_NOMEM);
    x = p->bed_table;
    y = x + t->n;
    z = y + t->n;
    for (int pass = 0; pass < 2; pass++) {
        if (pass == 1 &&
            (bed->nx < 2 || bed->ny < 2 || t->n / bed->ny != bed->nx || t->n % bed->ny != 0))
            return fail(why, SW_FORMAT, "%.400s: %d points for %d x by %d y: no full grid", t->name,
                        t->n, bed->nx, bed->ny);
        for (int i = 0; i < t->n && pass == 1; i++)
            z[i] = NAN;
        for (int i = 0; i < t->n && s == SW_OK; i++) {
            for (int c = 0; c < 3 && s == SW_OK; c++)
                s = sheet_number(t, i, c, -SYSTEM_BIG, SYSTEM_BIG, NAN, &point[c], why);
            if (s == SW_OK) {
                int at = place_of(point[0], x, &bed->nx);
                double *to = z + at + (long)bed->nx * place_of(point[1], y, &bed->ny);

                if (pass == 1 && !isnan(*to))
                    s = sheet_fail(why, t, i, "this point is there already");
                if (pass == 1)
                    *to = point[2];
            }
        }
        if (s != SW_OK)
            return s;
    }
    bed->kind = BED_GRID;
    bed->x = x;
    bed->y = y;
    bed->z = z;
    return SW_OK;
}

static enum status take_current(const struct sheet *t, struct system *p, struct why *why)
{
    double *z = mem_doubles(3 * (size_t)t->n), *u = z + t->n, *v = u + t->n, speed, direction;
    enum status s = SW_OK;

    p->current_table = z;
    if (!z)
        return fail_plain(why, SW_NOMEM);
    for (int i = 0; i < t->n && s == SW_OK; i++) {
        s = sheet_number(t, i, 0, -SYSTEM_BIG, SYSTEM_BIG, NAN, &z[i], why);
        if (s == SW_OK)
            s = sheet_number(t, i, 1, 0, 1e3, NAN, &speed, why);
        if (s == SW_OK)
            s = sheet_number(t, i, 2, -3600, 3600, NAN, &direction, why);
        if (s == SW_OK && i > 0 &&
            !(z[i] != z[i - 1] && (i == 1 || (z[i] > z[i - 1]) == (z[1] > z[0]))))
            s = sheet_fail(why, t, i, "heights must ascend or descend");
        if (s != SW_OK)
            return s;
        u[i] = speed * cos(direction * PI / 180);
        v[i] = speed * sin(direction * PI / 180);
    }
    for (int i = 0, j = t->n - 1; t->n > 1 && z[0] > z[1] && i < j; i++, j--)
        for (int c = 0; c < 3; c++) {
            double *list = z + c * t->n, swap = list[i];

            list[i] = list[j];
            list[j] = swap;
        }
    p->sea.current = (struct current){t->n, z, u, v};
    return SW_OK;
}

enum status system_read_sea(const char *path, struct system *p, struct why *why)
{
    const struct system_case *c = &p->c;
    struct sheet t;
    enum status s = SW_OK;

    if (!isnan(c->depth))
        p->sea.bed = (struct bed){.kind = BED_PLANE,
                                  .level = -c->depth,
                                  .slope = {c->slope[0], c->slope[1]}};
    else if (c->slope[0] != 0 || c->slope[1] != 0)
        return fail(why, SW_FORMAT, "%.400s: [environment] bed_slope needs a depth", path);
    if (c->bed[0] != '\0') {
        if (!isnan(c->depth))
            return fail(why, SW_FORMAT, "%.400s: [environment] give either depth or bed", path);
        s = sheet_read(c->bed, path, bed_column, 3, &t, why);
        if (s != SW_OK)
            return s;
        s = take_grid(&t, p, why);
        sheet_free(&t);
    }
    if (s == SW_OK && c->current[0] != '\0' && p->sea.current.n == 0) {
        s = sheet_read(c->current, path, current_column, 3, &t, why);
        if (s != SW_OK)
            return s;
        s = take_current(&t, p, why);
        sheet_free(&t);
    }
    if (p->sea.bed.kind != BED_NONE || p->sea.current.n > 0)
        p->net.sea = &p->sea;
    return s;
}
