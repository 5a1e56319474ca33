/* modal: eigenfrequencies and modes of one cable; writes the model directory. */
#include "form/modeldir.h"
#include "form/start.h"

#include <limits.h>

static struct {
    struct opt_common common;
    long modes;
} args;

static const struct opt options[] = {
    OPT_OUT(&args.common),
    {NULL, 'd', OPT_TEXT, &args.common.dir, "DIR", "write the model directory", 0, 0},
    {"modes", 0, OPT_INTEGER, &args.modes, "K", "only the K lowest modes", 1, INT_MAX},
    OPT_COMMON(&args.common),
};

static const struct opt_tool tool = {
    "modal", "CASE", "Eigenfrequencies and modes of one cable about its static line.", options};

static void print_modes(const struct modes *p, struct out *o)
{
    fputs("mode,omega_rad_s,frequency_Hz,period_s,plane\n", o->f);
    for (int i = 0; i < p->k; i++) {
        double f = hertz(p->omega[i]);
        const double row[] = {p->omega[i], f, 1 / f};

        fprintf(o->f, "%d,", i + 1);
        for (int j = 0; j < 3; j++) {
            out_number(o, row[j]);
            putc(',', o->f);
        }
        fputs(p->plane[i] == PART_PLANE ? "in\n" : "out\n", o->f);
    }
}

int main(int argc, char **argv)
{
    static struct cable_case c;
    struct model m;
    struct modes modes;
    struct out o;
    struct why why;
    enum status s;

    start_case(&tool, &args.common, argc, argv, &c);
    if (args.modes > 6L * c.elements)
        die(SW_USAGE, "option --modes: the mesh has only %d modes", 6 * c.elements);
    s = case_model(&c, &m);
    if (s == SW_OK)
        s = modes_lowest(&m, args.modes > 0 ? (int)args.modes : 6 * c.elements, SOLVER_AUTO,
                         &modes);
    if (s == SW_ADMISSIBLE)
        die(s, "all modes are solved for at once, which takes up to %d elements; the case has %d",
            MODES_MAX_ELEMENTS, c.elements);
    if (s != SW_OK)
        die(s, "modes of %d elements: %s", c.elements, status_text(s));
    if (args.common.dir)
        must(modeldir_make(args.common.dir, &why), &why);
    must(out_open(&o, args.common.out, &why), &why);
    if (args.common.dir)
        must(modeldir_write(args.common.dir, &c, &m, &modes, &why), &why);
    print_modes(&modes, &o);
    must(out_close(&o, &why), &why);
    modes_free(&modes);
    model_free(&m);
    case_free(&c);
    return 0;
}
