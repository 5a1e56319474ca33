/* Beginning of a tool that works on a case file. */
#include "form/start.h"
#include "form/units.h"

#include <math.h>
#include <stdlib.h>

void start_doubt(const struct cable_case *c, const struct line *line, const char *place)
{
    double density = c->bare.mu / c->area, slack = c->bare.L0 / line_chord(&c->bare), strain;
    double damping = sqrt(c->alpha * c->beta); /* least of alpha/(2 omega) + beta omega/2 */
    struct line_point right;

    line_at(line, line->cable.L0, &right);
    strain = fmax(hypot(line->H, line->V), right.tension) / line->cable.EA;
    if (units_doubt_density(density, UNITS_LIGHT))
        warn("%smass_per_length and area make a density of %.3g kg/m3: are the units right?", place,
             density);
    if (c->youngs_modulus < 1e8 || c->youngs_modulus > 1e12)
        warn("%syoungs_modulus = %.3g Pa: is the unit right?", place, c->youngs_modulus);
    if (strain > UNITS_STRAIN)
        warn("%sthe cable is stretched by %.3g %%: are the units right?", place, 100 * strain);
    if (slack > 3)
        warn("%sthe cable is %.3g times as long as its chord: are the units right?", place, slack);
    if (c->load.temperature != 0 && c->load.expansion == 0)
        warn("%stemperature_change does nothing without an expansion_coefficient", place);
    if (damping > 0.5)
        warn("%sall motions are damped with a ratio of %.3g or more: is zeta in per cent?", place,
             damping);
}

int start_options(const struct opt_tool *tool, const struct opt_common *common, int argc,
                  char **argv)
{
    int operand;

    out_prepare();
    err_tool(tool->name);
    operand = opt_parse(tool, argc, argv);
    err_level(common->quiet, common->verbose);
    return operand;
}

void start_load(const struct opt_tool *tool, struct opt_common *common, int operand, int argc,
                char **argv, struct cable_case *ret)
{
    struct line line;
    struct why why;

    if (operand != argc - 1)
        opt_usage(tool);
    must(case_load(argv[operand], &common->sets, ret, &why), &why);
    if (line_solve(&ret->cable, &line) == SW_OK)
        start_doubt(ret, &line, "");
    if (ret->found)
        note("unstressed length %.12g m", ret->bare.L0);
    if (common->print_case) {
        struct out o;

        must(out_open(&o, common->out, &why), &why);
        case_print(ret, &o);
        must(out_close(&o, &why), &why);
        case_free(ret);
        opt_list_free(&common->sets);
        exit(0);
    }
}

void start_case(const struct opt_tool *tool, struct opt_common *common, int argc, char **argv,
                struct cable_case *ret)
{
    start_load(tool, common, start_options(tool, common, argc, argv), argc, argv, ret);
}
