/* catenary: static line of one elastic cable under its own weight. */
#include "form/start.h"
#include "phys/line.h"

#include <math.h>

static struct {
    struct opt_common common;
    int summary;
} args;

static const struct opt options[] = {
    OPT_OUT(&args.common),
    {"summary", 0, OPT_FLAG, &args.summary, NULL, "one row of reactions, sag and lambda^2 instead",
     0, 0},
    OPT_COMMON(&args.common),
};

static const struct opt_tool tool = {"catenary", "CASE",
                                     "Static line of one elastic cable under its own weight.",
                                     options};

static void print_line(const struct line *s, int elements, struct out *o)
{
    fputs("theta_m,x1_m,x2_m,tension_N,slope,angle_rad\n", o->f);
    for (int k = 0; k <= elements; k++) {
        struct line_point p;

        line_at(s, s->cable.L0 * ((double)k / elements), &p);
        out_row(o, (double[]){p.theta, p.x1, p.x2, p.tension, p.V / s->H, atan2(p.V, s->H)}, 6);
    }
}

static void print_summary(const struct line *s, struct out *o)
{
    const struct cable *c = &s->cable;
    struct line_point left, mid, right;

    line_at(s, 0, &left);
    line_at(s, c->L0 / 2, &mid);
    line_at(s, c->L0, &right);
    fputs("horizontal_force_N,vertical_left_N,vertical_right_N,tension_left_N,tension_mid_N,"
          "tension_right_N,sag_m,length_m,lambda2\n",
          o->f);
    out_row(o,
            (double[]){s->H, s->V, s->W - s->V, left.tension, mid.tension, right.tension,
                       line_sag(s), line_length(s), line_lambda2(s, c->mu * c->L0 / line_chord(c))},
            9);
}

int main(int argc, char **argv)
{
    static struct cable_case c;
    struct line line;
    struct out o;
    struct why why;
    enum status s;

    start_case(&tool, &args.common, argc, argv, &c);
    s = line_solve(&c.cable, &line);
    if (s != SW_OK)
        die(s, "static line: %s", status_text(s));
    note("%d Newton steps", line.steps);
    must(out_open(&o, args.common.out, &why), &why);
    if (args.summary)
        print_summary(&line, &o);
    else
        print_line(&line, c.elements, &o);
    must(out_close(&o, &why), &why);
    case_free(&c);
    return 0;
}
