/* wirebeam: curved and twisted wires, strands and springs, in small and large deformation. */
#include "form/start.h"
#include "form/wiredoubt.h"
#include "phys/updated.h"
#include "phys/vibrate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct {
    struct opt_common common;
    const char *method;
    long modes;
    int stresses;
} args;

static const struct opt options[] = {
    OPT_OUT(&args.common),
    {NULL, 'd', OPT_TEXT, &args.common.dir, "DIR", "write all tables there", 0, 0},
    {"method", 0, OPT_TEXT, &args.method, "equilibrium|linear|updated", "how to solve", 0, 0},
    {"modes", 0, OPT_INTEGER, &args.modes, "K", "the K lowest natural frequencies where it rests",
     1, 1000},
    {"stresses", 0, OPT_FLAG, &args.stresses, NULL, "stresses beside the section forces", 0, 0},
    OPT_COMMON(&args.common),
};

static const struct opt_tool tool = {
    "wirebeam", "CASE", "Curved wires, strands and springs in small and large deformation.",
    options, wire_name_keys};

static struct wire_case c;
static struct wire all;
static struct wire_result result;

/* --method is a shorter way to say the key of [solve]; --set goes first. */
static void set_method(void)
{
    static const char *const word[] = {"equilibrium", "linear", "updated"};

    for (int k = WIRE_EQUILIBRIUM; k <= WIRE_UPDATED && args.method; k++)
        if (strcmp(args.method, word[k]) == 0) {
            c.method = k;
            return;
        }
    if (args.method)
        die(SW_USAGE, "option --method: '%s' is not one of: equilibrium linear updated",
            args.method);
}

static void load(const char *path)
{
    const char *refused;
    struct why why;

    must(wire_case_load(path, &args.common.sets, &c, &why), &why);
    set_method();
    if (args.common.print_case) {
        struct out o;

        must(out_open(&o, args.common.out, &why), &why);
        wire_case_print(&c, &o);
        must(out_close(&o, &why), &why);
        exit(0);
    }
    must(wire_load(path, &c, &all, &why), &why);
    wire_doubt(&all);
    refused = c.method == WIRE_UPDATED ? updated_refused(&all.frame) : NULL;
    if (refused)
        die(SW_ADMISSIBLE, "method updated does not take %s", refused);
    if (args.modes > 0 && c.method != WIRE_EQUILIBRIUM)
        die(SW_USAGE, "option --modes belongs to method equilibrium");
}

static const char *node_name(int i)
{
    return i < 0 ? "(a hinge)" : i < all.nodes.n ? wire_node(&all, i) : "(within an element)";
}

/* End without a valid result; how far it came goes to the directory. */
static void give_up(enum status s)
{
    const struct follow_path *p = &result.path;
    struct why why;

    if (s == SW_INDEFINITE)
        die(s, "a mechanism: nothing holds node '%s'", node_name(p->failed_node));
    if (s != SW_NOCONV)
        die(s, "%s", status_text(s));
    if (args.common.dir)
        must(wire_write(args.common.dir, &all, &result, &why), &why);
    if (c.method == WIRE_UPDATED)
        die(s, "method updated: step %d of %d did not come to rest; take more steps",
            p->n > 0 ? p->n - 1 : 0, c.steps);
    die(s,
        "no equilibrium found beyond time %.6g, after %d steps; the largest turn within an element "
        "is %.3g degrees there",
        result.s.t, p->n > 0 ? p->n - 1 : 0, p->angle * 180 / acos(-1));
}

static enum status run(void)
{
    const struct follow_options o = {.tolerance = c.tolerance,
                                     .parts = c.steps,
                                     .steps = c.most_steps,
                                     .iterations = c.iterations,
                                     .arc = c.path == WIRE_BY_ARC,
                                     .critical = c.critical,
                                     .watch = all.watch};
    const struct frame *f = &all.frame;

    switch (c.method) {
    case WIRE_LINEAR: return follow_linear(f, &result.s, &result.w, &result.path.failed_node);
    case WIRE_UPDATED: return updated(f, &o, &result.s, &result.w, &result.path);
    default: return follow(f, &o, &result.s, &result.w, &result.path);
    }
}

/* What rests unloaded may be free: then there is nothing to solve, and modes are all that is asked
 * for. */
static void solve(void)
{
    enum status s = frame_state_new(&all.frame, &result.s);

    result.path = (struct follow_path){.critical = NAN};
    if (s == SW_OK)
        s = frame_work_new(&all.frame, &result.w);
    if (s == SW_OK && (all.moved || args.modes == 0))
        s = run();
    else if (s == SW_OK)
        frame_evaluate(&all.frame, &result.s, FRAME_STILL, &result.w);
    result.status = s;
    if (s != SW_OK)
        give_up(s);
}

static void remark(void)
{
    const struct follow_path *p = &result.path;

    if (p->n > 0 && c.method == WIRE_EQUILIBRIUM) {
        const struct follow_step *last = &p->step[p->n - 1];

        note("%d steps, residual %.3g, largest turn within an element %.3g degrees", p->n - 1,
             last->residual, p->angle * 180 / acos(-1));
        if (!isnan(p->critical))
            warn("stability is lost at time %.9g; the result is just before", p->critical);
        else if (c.critical)
            warn("stability was not lost until time %.6g", result.s.t);
        else if (last->negative > 0)
            warn("the equilibrium is unstable: %d negative pivots", last->negative);
        if (c.path == WIRE_BY_ARC && result.s.t < all.frame.stages)
            warn("the path ends after %d steps at time %.6g", p->n - 1, result.s.t);
    }
    if (args.stresses) {
        int worst;
        double most = wire_worst(&all, &result, &worst);

        if (worst < 0)
            warn("no section tells its extent: ex_m, ey_m, Wt_m3");
        else
            note("largest stress %.6g Pa in element '%s'", most, wire_element(&all, worst));
    }
}

static void vibrate_about(void)
{
    enum status s;

    if (args.modes > result.w.unknowns)
        die(SW_USAGE, "option --modes: there are only %d unknowns", result.w.unknowns);
    result.modes = (int)args.modes;
    result.lambda = calloc((size_t)args.modes, sizeof *result.lambda);
    result.shape = calloc((size_t)args.modes * 6 * (size_t)all.frame.n, sizeof *result.shape);
    if (!result.lambda || !result.shape)
        die(SW_NOMEM, "%s", status_text(SW_NOMEM));
    for (int i = 0; i < all.frame.beams; i++)
        if (!(all.frame.beam[i].section->mass > 0))
            die(SW_ADMISSIBLE,
                "--modes: the section of element '%s' has no density_kg_m3 or mass_kg_m",
                wire_element(&all, all.piece[i].element));
    s = vibrate(&all.frame, &result.s, &result.w, result.modes, result.lambda, result.shape);
    if (s != SW_OK)
        die(s, "--modes: %s", status_text(s));
}

static void print_results(void)
{
    struct out o;
    struct why why;

    if (args.common.dir) {
        must(wire_write(args.common.dir, &all, &result, &why), &why);
        return;
    }
    must(out_open(&o, args.common.out, &why), &why);
    if (args.modes > 0)
        wire_print_modes(&result, &o);
    else if (args.stresses)
        wire_print_forces(&all, &result, &o);
    else
        wire_print_nodes(&all, &result, &o);
    must(out_close(&o, &why), &why);
}

int main(int argc, char **argv)
{
    int operand = start_options(&tool, &args.common, argc, argv);

    if (operand != argc - 1)
        opt_usage(&tool);
    if (args.common.out && args.common.dir)
        die(SW_USAGE, "options -o and -d: all tables go to the directory");
    load(argv[operand]);
    result.stresses = args.stresses;
    solve();
    remark();
    if (wire_doubt_result(&all, &result) != SW_OK)
        die(SW_NOMEM, "%s", status_text(SW_NOMEM));
    if (args.modes > 0)
        vibrate_about();
    print_results();
    wire_result_free(&result);
    wire_free(&all);
    opt_list_free(&args.common.sets);
    return 0;
}
