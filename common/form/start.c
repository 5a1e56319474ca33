/* Beginning of a tool that works on a case file. */
#include "form/start.h"
#include "form/units.h"

#include <stdlib.h>

static void warn_of_units(const struct cable_case *c)
{
    double density = c->bare.mu / c->area, strain = line_chord(&c->bare) / c->bare.L0 - 1;

    if (units_doubt_density(density, UNITS_LIGHT))
        warn("mass_per_length and area make a density of %.3g kg/m3: are the units right?",
             density);
    if (c->youngs_modulus < 1e8 || c->youngs_modulus > 1e12)
        warn("youngs_modulus = %.3g Pa: is the unit right?", c->youngs_modulus);
    if (strain > UNITS_STRAIN)
        warn("the chord is %.3g %% longer than the unstressed cable: are the units right?",
             100 * strain);
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
    struct why why;

    if (operand != argc - 1)
        opt_usage(tool);
    must(case_load(argv[operand], &common->sets, ret, &why), &why);
    warn_of_units(ret);
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
