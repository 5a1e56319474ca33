/* Beginning of a tool that works on a case file. */
#include "form/start.h"

#include <stdlib.h>

void start_case(const struct opt_tool *tool, struct opt_common *common, int argc, char **argv,
                struct cable_case *ret)
{
    struct why why;
    int operand;

    out_prepare();
    err_tool(tool->name);
    operand = opt_parse(tool, argc, argv);
    err_level(common->quiet, common->verbose);
    if (operand != argc - 1)
        opt_usage(tool);
    must(case_load(argv[operand], &common->sets, ret, &why), &why);
    opt_list_free(&common->sets);
    if (common->print_case) {
        struct out o;

        must(out_open(&o, common->out, &why), &why);
        case_print(ret, &o);
        must(out_close(&o, &why), &why);
        case_free(ret);
        exit(0);
    }
}
