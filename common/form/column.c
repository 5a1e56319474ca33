/* Columns of sling: names, units, types. */
#include "form/column.h"
#include "num/pi.h"
#include "sys/near.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define DEGREE (PI / 180)

/* Quantities of struct rigging and struct detail: stem and unit of the column, SI units in one of
 * it. */
static const struct quantity {
    const char *stem, *unit;
    double factor;
} quantities[LIFT_QUANTITIES] = {
    {"v", "_m", 1},
    {"s", "_m", 1},
    {"z", "_m", 1},
    {"phi", "_deg", DEGREE},
    {"gamma", "_deg", DEGREE},
    {"m_spreader", "_t", 1000},
    {"m_load", "_t", 1000},
    {"sling", "_m", 1},
    {"base_long", "_m", 1},
    {"base_cross", "_m", 1},
    {"strain_wll", "", 1},
    {"use", "", 1},
    {"wll", "_kN", 1000},
    {"wll_secondary", "_kN", 1000},
    {"slings", "", 1},
    {"stabilized", "", 1},
    {"strain_secondary", "", 1},
    {"hooks", "", 1},
    {"hook_distance", "_m", 1},
    {"spreader_width", "_m", 1},
    {"edge_width", "_m", 1},
    {"edge_height", "_m", 1},
    {"low_edge_width", "_m", 1},
    {"low_edge_height", "_m", 1},
    {"load_long", "_m", 1},
    {"load_cross", "_m", 1},
    {"load_height", "_m", 1},
};

static const char *const alone[] = {"e1_m", "e2_m", "offset_m"};
static const char *const types[] = {"single", "primary", "primary-elastic", "primary-secondary",
                                    "pair"};

const char *lift_type_name(int type)
{
    return type >= 0 && type <= LIFT_PAIR ? types[type] : "";
}

void lift_name(int i, char ret[LIFT_NAME])
{
    if (i >= LIFT_E1) {
        snprintf(ret, LIFT_NAME, "%s", alone[i - LIFT_E1]);
    } else {
        const struct quantity *q = &quantities[i / LIFT_ENDS];
        const char *const ends[] = {"", "_1", "_2"};

        snprintf(ret, LIFT_NAME, "%s%s%s", q->stem, ends[i % LIFT_ENDS], q->unit);
    }
}

void lift_name_columns(FILE *f)
{
    fputs("type", f);
    for (int q = 0; q < LIFT_QUANTITIES; q++)
        fprintf(f, " %s%s", quantities[q].stem, quantities[q].unit);
    for (size_t i = 0; i < sizeof alone / sizeof *alone; i++)
        fprintf(f, " %s", alone[i]);
}

int lift_is_input(int i)
{
    int q = i / LIFT_ENDS;

    return i != LIFT_OFFSET &&
           (i >= LIFT_E1 || (q < LIFT_STABILIZED && q != LIFT_SLINGS && q != LIFT_WLL_SECONDARY));
}

int lift_may_vary(int i)
{
    return lift_is_input(i) || i == LIFT_OFFSET ||
           (i < LIFT_E1 && i / LIFT_ENDS == LIFT_WLL_SECONDARY);
}

const char *lift_stem(int quantity)
{
    return quantities[quantity].stem;
}

double lift_unit(int i)
{
    return i < LIFT_E1 ? quantities[i / LIFT_ENDS].factor : 1;
}

/* name without the end that it names, 0: none: "v_1_m" and "v_m_1" are "v_m" of end 1. */
static int strip_end(const char *name, const struct quantity *q)
{
    size_t stem = strlen(q->stem), unit = strlen(q->unit);
    const char *rest = name + stem;

    if (strncmp(name, q->stem, stem) != 0)
        return -1;
    if (strcmp(rest, q->unit) == 0)
        return 0;
    for (int end = 1; end < LIFT_ENDS; end++) {
        const char suffix[] = {'_', (char)('0' + end), '\0'};

        if ((strncmp(rest, suffix, 2) == 0 && strcmp(rest + 2, q->unit) == 0) ||
            (strncmp(rest, q->unit, unit) == 0 && strcmp(rest + unit, suffix) == 0))
            return end;
    }
    return -1;
}

static int number_column(const char *name)
{
    for (int q = 0; q < LIFT_QUANTITIES; q++) {
        int end = strip_end(name, &quantities[q]);

        if (end >= 0)
            return q * LIFT_ENDS + end;
    }
    for (int i = 0; i < LIFT_NUMBERS - LIFT_E1; i++)
        if (strcmp(name, alone[i]) == 0)
            return LIFT_E1 + i;
    return -1;
}

int lift_column(const char *name, int *ret_tolerance)
{
    size_t n = strlen(name);
    char stem[LIFT_NAME + 8];
    int i;

    *ret_tolerance = n > 4 && n < sizeof stem && strcmp(name + n - 4, "_tol") == 0;
    if (!*ret_tolerance)
        return number_column(name);
    memcpy(stem, name, n - 4);
    stem[n - 4] = '\0';
    i = number_column(stem);
    return i >= 0 && lift_may_vary(i) ? i : -1;
}

/* Lower case letters and digits of name before its unit. */
static void plain(const char *name, char ret[LIFT_NAME])
{
    static const char *const units[] = {"m", "mm", "cm", "deg", "rad", "t", "kg", "kn", "n", "tol"};
    size_t n = 0;
    char *unit;

    for (; *name && n < LIFT_NAME - 1; name++)
        ret[n++] = *name == '-' || *name == ' ' || *name == '.' ? '_'
                   : *name >= 'A' && *name <= 'Z'               ? (char)(*name + ('a' - 'A'))
                                                                : *name;
    ret[n] = '\0';
    unit = strrchr(ret, '_');
    for (size_t i = 0; unit && i < sizeof units / sizeof *units; i++)
        if (strcmp(unit + 1, units[i]) == 0) {
            *unit = '\0';
            return;
        }
}

const char *lift_nearly(const char *name, char ret[LIFT_NAME])
{
    char mine[LIFT_NAME], its[LIFT_NAME];

    plain(name, mine);
    for (int i = 0; i < LIFT_NUMBERS; i++) {
        lift_name(i, ret);
        plain(ret, its);
        if (strcmp(mine, its) == 0 || (strlen(its) >= 4 && i < LIFT_E1 && near_word(mine, its)) ||
            (strlen(ret) >= 5 && near_word(name, ret)))
            return ret;
    }
    snprintf(ret, LIFT_NAME, "type");
    return strcmp(mine, "typ") == 0 || strcmp(mine, "type") == 0 ? ret : NULL;
}

enum status lift_type_read(const char *text, int *ret, struct why *why)
{
    for (int k = 0; k <= LIFT_PAIR; k++)
        if (strcmp(text, types[k]) == 0) {
            *ret = k;
            return SW_OK;
        }
    return fail(why, SW_FORMAT,
                "'%.60s': expected single, primary, primary-elastic, primary-secondary or pair",
                text);
}
