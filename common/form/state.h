/*
 * The state of a march in a file, from which it goes on as if it had never stopped, or from which
 * another one starts.
 *
 * A NumPy vector: a head of STATE_HEAD numbers (enum state_head), then V, D and dd over all nodes
 * (phys/march.h), of the implicit scheme V, velocity and acceleration, then more numbers of the
 * run.
 */
#ifndef SEILWERK_FORM_STATE_H
#define SEILWERK_FORM_STATE_H

#include "form/cable.h"
#include "phys/energy.h"

enum state_head {
    STATE_VERSION,
    STATE_CASE_HIGH, /* two halves of a checksum of the resolved case without time.end */
    STATE_CASE_LOW,
    STATE_ELEMENTS,
    STATE_DT,
    STATE_STEP,
    STATE_ROWS,   /* written */
    STATE_BYTES,  /* of the result that they make */
    STATE_FIELDS, /* columns of --field written */
    STATE_SLACK_TIME,
    STATE_SLACK_THETA,
    STATE_ENERGY, /* 12 numbers of struct energy */
    STATE_SCHEME = STATE_ENERGY + 12,
    STATE_MARK, /* the rest: of the implicit scheme, see struct alpha */
    STATE_TICK,
    STATE_STRIDE,
    STATE_SCALE,
    STATE_PAST,
    STATE_SETTLED,
    STATE_EVEN,
    STATE_WORST,
    STATE_HEAD = 40
};

/* What goes with the march itself. */
struct progress_mark {
    long rows, bytes, fields;
    double *more; /* (n_more) of the run; not owned */
    size_t n_more;
};

/* Two halves of a checksum of the resolved case without time.end, and of extra.  SW_NOMEM. */
enum status state_checksum(const struct cable_case *c, const char *extra, double *ret_high,
                           double *ret_low, struct why *why);

/* Write the state of m to path, whole or not at all.  extra tells of options that change the
 * result's columns: it goes into the checksum.  SW_WRITE, SW_NOMEM. */
enum status state_write(const char *path, const struct cable_case *c, const char *extra,
                        const struct march *m, const struct energy *e,
                        const struct progress_mark *mark, struct why *why);

/* Put the state of path into m, which belongs to the same case with at most another time.end.
 * SW_FORMAT: of another case, or damaged; SW_READ, SW_NOMEM. */
enum status state_resume(const char *path, const struct cable_case *c, const char *extra,
                         struct march *m, struct energy *e, struct progress_mark *mark,
                         struct why *why);

/* Path of the state: that given, or that of the result with .state behind it; NULL: neither is a
 * file.  To be freed.  SW_NOMEM. */
enum status state_path(const char *given, const char *result, char **ret, struct why *why);

/* Whether it is time for a state: so many seconds of wall time since *saved, the time of the last
 * one (0: none yet), which is then set. */
int state_due(double *saved, double seconds);

/* Whether there is a file at path that can be read. */
int state_is_there(const char *path);

/* Displacement V and velocity W of the state of path, of any case with the same number of elements,
 * both 6 (n + 1), to start from.  As state_resume. */
enum status state_start(const char *path, const struct model *m, double *V, double *W,
                        struct why *why);

#endif
