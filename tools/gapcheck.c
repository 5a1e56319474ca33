/* gapcheck: the proof of a solution of gapnet, from its tables alone. */
#include "form/netproof.h"
#include "form/start.h"

#define UNBALANCE 1e-8 /* of the largest tension */
#define GAP 1e-9       /* of the system's size */

static struct opt_common common;

static const struct opt options[] = {
    OPT_OUT(&common),
    {"quiet", 'q', OPT_FLAG, &common.quiet, NULL, "no warnings", 0, 0},
    {"verbose", 'v', OPT_FLAG, &common.verbose, NULL, "say what is done", 0, 0},
    {NULL, 0, OPT_FLAG, NULL, NULL, NULL, 0, 0},
};

static const struct opt_tool tool = {"gapcheck", "DIR",
                                     "The proof of a solution of gapnet, from its tables alone.",
                                     options, NULL};

static void print(const struct net_proof *p, struct out *o)
{
    fputs("nodes,ropes,points,largest_tension_N,size_m,node_residual,worst_node,joint_residual,"
          "worst_rope,gap,gap_rope,bed_pull,bed_rope\n",
          o->f);
    fprintf(o->f, "%d,%d,%d,", p->nodes, p->ropes, p->points);
    out_number(o, p->tension);
    putc(',', o->f);
    out_number(o, p->size);
    putc(',', o->f);
    out_number(o, p->unbalance);
    putc(',', o->f);
    out_cell(o, p->node);
    putc(',', o->f);
    out_number(o, p->joint);
    putc(',', o->f);
    out_cell(o, p->rope);
    putc(',', o->f);
    out_number(o, p->gap);
    putc(',', o->f);
    out_cell(o, p->gap_rope);
    putc(',', o->f);
    out_number(o, p->bed);
    putc(',', o->f);
    out_cell(o, p->bed_rope);
    putc('\n', o->f);
}

int main(int argc, char **argv)
{
    int operand = start_options(&tool, &common, argc, argv);
    struct net_proof p;
    struct out o;
    struct why why;

    if (operand != argc - 1)
        opt_usage(&tool);
    must(net_prove(argv[operand], &p, &why), &why);
    must(out_open(&o, common.out, &why), &why);
    print(&p, &o);
    must(out_close(&o, &why), &why);
    if (!(p.unbalance <= UNBALANCE))
        die(SW_NOCONV, "%s: node '%s' is out of balance by %.3g of the largest tension",
            argv[operand], p.node, p.unbalance);
    if (!(p.joint <= UNBALANCE))
        die(SW_NOCONV, "%s: rope '%s' is out of balance by %.3g of the largest tension",
            argv[operand], p.rope, p.joint);
    if (!(p.gap <= GAP))
        die(SW_NOCONV, "%s: rope '%s' misses by %.3g of the system's size", argv[operand],
            p.gap_rope, p.gap);
    if (!(p.bed <= UNBALANCE))
        die(SW_NOCONV, "%s: the bed pulls at rope '%s' by %.3g of the largest tension",
            argv[operand], p.bed_rope, p.bed);
    return 0;
}
