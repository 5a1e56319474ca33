/* Columns of results of sling. */
#include "form/result.h"
#include "num/pi.h"

#include <math.h>

#define KILO(x) ((x) / 1000)
#define DEGREES(x) ((x) * (180 / PI))

/* Numbers that follow the five fixed columns. */
#define RESULTS(X)                                                                                 \
    X(h_long_m, j->view[RIGGING_LONG])                                                             \
    X(h_cross_m, j->view[RIGGING_CROSS])                                                           \
    X(h_document_m, j->document_least)                                                             \
    X(h_document_long_m, j->document[RIGGING_LONG])                                                \
    X(h_document_cross_m, j->document[RIGGING_CROSS])                                              \
    X(rise_critical_m, j->rise)                                                                    \
    X(v_critical_m, j->v_critical)                                                                 \
    X(gamma_critical_deg, DEGREES(j->gamma_critical))                                              \
    X(centre_m, j->centre)                                                                         \
    X(virtual_m, j->virtual_centre)                                                                \
    X(tilt_spreader_deg, DEGREES(j->at.spreader))                                                  \
    X(tilt_load_deg, DEGREES(j->at.load))                                                          \
    X(force_low_kN, KILO(j->at.primary_low))                                                       \
    X(force_high_kN, KILO(j->at.primary_high))                                                     \
    X(use_primary, j->use_primary)                                                                 \
    X(secondary_low_kN, KILO(j->at.secondary_low))                                                 \
    X(secondary_high_kN, KILO(j->at.secondary_high))                                               \
    X(use_secondary, j->use_secondary)                                                             \
    X(moment_0_kNm, KILO(j->at.moment_0))                                                          \
    X(moment_kNm, KILO(j->at.moment))                                                              \
    X(range_deg, DEGREES(j->at.range))

/* Of each end of a pair. */
#define END_RESULTS(X, k, e)                                                                       \
    X(c_##k, e.c)                                                                                  \
    X(h_##k##_m, e.h)                                                                              \
    X(m_##k##_t, KILO(e.m))                                                                        \
    X(centre_##k##_m, e.centre)                                                                    \
    X(virtual_##k##_m, e.virtual_centre)                                                           \
    X(tilt_spreader_##k##_deg, DEGREES(e.at.spreader))                                             \
    X(force_low_##k##_kN, KILO(e.at.primary_low))                                                  \
    X(force_high_##k##_kN, KILO(e.at.primary_high))                                                \
    X(use_primary_##k, e.use_primary)                                                              \
    X(secondary_low_##k##_kN, KILO(e.at.secondary_low))                                            \
    X(secondary_high_##k##_kN, KILO(e.at.secondary_high))                                          \
    X(use_secondary_##k, e.use_secondary)
#define PAIR_RESULTS(X)                                                                            \
    X(h_coupled_m, j->coupled)                                                                     \
    END_RESULTS(X, 1, j->end[0])                                                                   \
    END_RESULTS(X, 2, j->end[1])

/* Of exact statics. */
#define EXACT_RESULTS(X)                                                                           \
    X(exact_h_m, e->h)                                                                             \
    X(exact_h_load_m, e->load)                                                                     \
    X(exact_h_long_m, e->view[RIGGING_LONG])                                                       \
    X(exact_h_cross_m, e->view[RIGGING_CROSS])                                                     \
    X(exact_h_edges_m, e->contact)                                                                 \
    X(exact_tilt_spreader_deg, DEGREES(e->tilt_spreader))                                          \
    X(exact_tilt_load_deg, DEGREES(e->tilt_load))                                                  \
    X(offset_lost_m, e->offset_lost)                                                               \
    X(capsizing_deg, DEGREES(e->capsizing))                                                        \
    X(capsizing_energy_kJ, KILO(e->energy))                                                        \
    X(moment_max_kNm, KILO(e->moment))                                                             \
    X(moment_max_deg, DEGREES(e->moment_at))                                                       \
    X(exact_force_low_kN, KILO(e->greatest[EXACT_PRIMARY]))                                        \
    X(exact_force_high_kN, KILO(e->least[EXACT_PRIMARY]))                                          \
    X(exact_use_primary, e->use[EXACT_PRIMARY])                                                    \
    X(exact_secondary_low_kN, KILO(e->greatest[EXACT_SECONDARY]))                                  \
    X(exact_secondary_high_kN, KILO(e->least[EXACT_SECONDARY]))                                    \
    X(exact_use_secondary, e->use[EXACT_SECONDARY])                                                \
    X(omega2_1_s2, e->omega2)                                                                      \
    X(period_s, e->period)                                                                         \
    X(rest_deg, DEGREES(e->rest))                                                                  \
    X(by_contact, e->by_contact)                                                                   \
    X(contacts, e->contacts)                                                                       \
    X(slack, e->slack)                                                                             \
    X(indeterminate, e->indeterminate)

#define COLUMN(name, value) "," #name
#define VALUE(name, value) value,

void result_cell(struct out *o, double x)
{
    putc(',', o->f);
    if (!isnan(x))
        out_number(o, x);
}

void result_cells(struct out *o, const double *x, size_t n)
{
    for (size_t i = 0; i < n; i++)
        result_cell(o, x[i]);
}

void result_header(const struct result_asked *a, struct out *o)
{
    fputs(",c,h_m,z_critical_m,verdict,why" RESULTS(COLUMN), o->f);
    if (a->ends)
        fputs(PAIR_RESULTS(COLUMN), o->f);
    if (a->exact)
        fputs(EXACT_RESULTS(COLUMN) ",capsizing,mode", o->f);
}

static void print_exact(const struct exact *e, struct out *o)
{
    const double x[] = {EXACT_RESULTS(VALUE)};

    result_cells(o, x, sizeof x / sizeof *x);
    fprintf(o->f, ",%s,%s", exact_end(e), e->mode);
}

static void print_no_exact(struct out *o)
{
    fputs(",,", o->f);
    for (const char *c = EXACT_RESULTS(COLUMN); *c; c++)
        if (*c == ',')
            putc(',', o->f);
}

void result_row(const struct judgement *j, const struct result_asked *a, const struct exact *e,
                struct out *o)
{
    const double first[] = {j->c, j->h, j->z_critical}, more[] = {RESULTS(VALUE)};

    result_cells(o, first, 3);
    fprintf(o->f, ",%s,", verdict_name(j->verdict));
    out_cell(o, j->why);
    result_cells(o, more, sizeof more / sizeof *more);
    if (a->ends) {
        const double ends[] = {PAIR_RESULTS(VALUE)};

        result_cells(o, ends, sizeof ends / sizeof *ends);
    }
    if (a->exact && e)
        print_exact(e, o);
    else if (a->exact)
        print_no_exact(o);
}
