/* Sections of wires from their table. */
#include "form/wiretables.h"
#include "num/mem.h"

#include <math.h>
#include <string.h>

enum {
    SHAPE = SECTION + 1,
    YOUNG,
    SHEAR,
    DENSITY,
    MASS,
    INERTIA,
    DIAMETER,
    WALL,
    WIDTH,
    HEIGHT,
    AREA,
    IXX,
    IYY,
    IT,
    EX,
    EY,
    WT,
    STIFF
};
const struct sheet_column wire_section_column[N_SECTION] = {
    {"section", 1},   {"shape", 0},        {"E_Pa", 0},       {"G_Pa", 0},     {"density_kg_m3", 0},
    {"mass_kg_m", 0}, {"inertia_kg_m", 0}, {"diameter_m", 0}, {"wall_m", 0},   {"width_m", 0},
    {"height_m", 0},  {"area_m2", 0},      {"Ixx_m4", 0},     {"Iyy_m4", 0},   {"It_m4", 0},
    {"ex_m", 0},      {"ey_m", 0},         {"Wt_m3", 0},      {"k_nn_N", 0},   {"k_nx_Nm", 0},
    {"k_ny_Nm", 0},   {"k_nt_Nm", 0},      {"k_xx_Nm2", 0},   {"k_xy_Nm2", 0}, {"k_xt_Nm2", 0},
    {"k_yy_Nm2", 0},  {"k_yt_Nm2", 0},     {"k_tt_Nm2", 0},   {"remark", 0}};

static const char *const shape_word[] = {"round", "tube", "rectangle", "values", "general"};

static enum status take_shape(const struct sheet *t, int row, struct section *to, struct why *why)
{
    const char *text = sheet_text(t, row, SHAPE);

    to->shape = SECTION_VALUES;
    if (text[0] == '\0')
        return SW_OK;
    for (int k = SECTION_ROUND; k <= SECTION_GENERAL; k++)
        if (strcmp(text, shape_word[k]) == 0) {
            to->shape = (enum section_shape)k;
            return SW_OK;
        }
    return sheet_fail(why, t, row,
                      "shape '%.60s' is none of round, tube, rectangle, values, general", text);
}

/* Whether a shape knows a column of the table. */
static int belongs(enum section_shape shape, int column)
{
    switch (column) {
    case DIAMETER: return shape == SECTION_ROUND || shape == SECTION_TUBE;
    case WALL: return shape == SECTION_TUBE;
    case WIDTH:
    case HEIGHT: return shape == SECTION_RECTANGLE;
    case AREA:
    case IXX:
    case IYY:
    case EX:
    case EY:
    case WT: return shape == SECTION_VALUES || shape == SECTION_GENERAL;
    case IT: return shape == SECTION_VALUES;
    case YOUNG:
    case SHEAR: return shape != SECTION_GENERAL;
    default: return column < STIFF || shape == SECTION_GENERAL;
    }
}

/* Numbers of a row: needed ones, others NAN. */
static enum status take_measures(const struct sheet *t, int row, struct section *s, double *density,
                                 struct why *why)
{
    const struct {
        int column, needed;
        double *to;
    } number[] = {{YOUNG, 1, &s->E},
                  {SHEAR, 1, &s->G},
                  {DENSITY, 0, density},
                  {MASS, 0, &s->mass},
                  {INERTIA, 0, &s->inertia[2]},
                  {DIAMETER, 1, &s->diameter},
                  {WALL, 1, &s->wall},
                  {WIDTH, 1, &s->width},
                  {HEIGHT, 1, &s->height},
                  {AREA, s->shape == SECTION_VALUES, &s->area},
                  {IXX, s->shape == SECTION_VALUES, &s->Ixx},
                  {IYY, s->shape == SECTION_VALUES, &s->Iyy},
                  {IT, 1, &s->It},
                  {EX, 0, &s->ex},
                  {EY, 0, &s->ey},
                  {WT, 0, &s->Wt}};
    enum status status = SW_OK;

    for (size_t k = 0; k < sizeof number / sizeof *number && status == SW_OK; k++) {
        int column = number[k].column;

        *number[k].to = NAN;
        if (!belongs(s->shape, column)) {
            if (sheet_text(t, row, column)[0] != '\0')
                return sheet_fail(why, t, row, "%s does not belong to the shape %s",
                                  wire_section_column[column].name, shape_word[s->shape]);
            continue;
        }
        if (number[k].needed && t->at[column] < 0)
            return sheet_fail(why, t, row, "the shape %s needs the column %s", shape_word[s->shape],
                              wire_section_column[column].name);
        if (!number[k].needed && sheet_text(t, row, column)[0] == '\0')
            continue;
        status = sheet_number(t, row, column, column <= INERTIA && column > SHEAR ? 0 : 1e-300,
                              WIRE_BIG, NAN, number[k].to, why);
    }
    return status;
}

/* The stiffness of a general section, upper triangle by rows. */
static enum status take_stiffness(const struct sheet *t, int row, struct section *s,
                                  struct why *why)
{
    enum status status = SW_OK;

    for (int i = 0, at = STIFF; i < 4; i++)
        for (int j = i; j < 4 && status == SW_OK; j++, at++) {
            if (i == j && t->at[at] < 0)
                return sheet_fail(why, t, row, "the shape general needs the column %s",
                                  wire_section_column[at].name);
            status = sheet_number(t, row, at, i == j ? 1e-300 : -WIRE_BIG, WIRE_BIG,
                                  i == j ? NAN : 0, &s->stiffness[i + 4 * j], why);
            s->stiffness[j + 4 * i] = s->stiffness[i + 4 * j];
        }
    return status;
}

static enum status take_section(const struct sheet *t, int row, struct section *s, struct why *why)
{
    double density = 0, mass, inertia;
    enum status status = take_shape(t, row, s, why);

    if (status == SW_OK)
        status = take_measures(t, row, s, &density, why);
    if (status == SW_OK && s->shape == SECTION_GENERAL)
        status = take_stiffness(t, row, s, why);
    for (int at = STIFF; at < N_SECTION - 1 && status == SW_OK; at++)
        if (s->shape != SECTION_GENERAL && sheet_text(t, row, at)[0] != '\0')
            return sheet_fail(why, t, row, "%s belongs to the shape general",
                              wire_section_column[at].name);
    if (status != SW_OK)
        return status;
    if (s->shape == SECTION_TUBE && !(s->wall <= s->diameter / 2))
        return sheet_fail(why, t, row, "the wall is thicker than half the diameter");
    if (!isnan(s->mass) && !isnan(density))
        return sheet_fail(why, t, row, "give either density_kg_m3 or mass_kg_m");
    mass = s->mass;
    inertia = s->inertia[2];
    s->mass = isnan(mass) ? 0 : mass;
    s->inertia[2] = 0;
    if (section_complete(s, isnan(density) ? 0 : density) != SW_OK)
        return sheet_fail(why, t, row, "the stiffness is not positive definite");
    if (!isnan(mass) && s->shape != SECTION_GENERAL) /* spread over the area */
        section_complete(s, mass / s->area);
    if (!isnan(inertia)) {
        s->inertia[2] = inertia;
        s->inertia[0] = s->inertia[1] = inertia / 2;
    }
    return SW_OK;
}

enum status wire_take_sections(struct wire *p, struct why *why)
{
    enum status s = SW_OK;

    p->section = mem_zeroed((size_t)p->sections.n, sizeof *p->section);
    if (!p->section)
        return fail_plain(why, SW_NOMEM);
    for (int i = 0; i < p->sections.n && s == SW_OK; i++)
        s = take_section(&p->sections, i, &p->section[i], why);
    return s;
}
