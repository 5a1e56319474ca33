/* gapnet: equilibrium of systems of ropes and nets by the gap method. */
#include "form/deck.h"
#include "form/netbodies.h"
#include "form/netdoubt.h"
#include "form/netfiles.h"
#include "form/nettarget.h"
#include "form/start.h"
#include "sys/number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SPLIT 5    /* of the elements of a chain: a continuous rope that must be split */
#define SLACK 1e-8 /* of the largest tension: a rope that carries nothing */

static struct {
    struct opt_common common;
    const char *method, *rope, *step, *stiffness, *about, *write_deck, *body, *move, *moves, *by;
    struct opt_list pretension;
    int verify, lint;
} args;

static const struct opt options[] = {
    OPT_OUT(&args.common),
    {NULL, 'd', OPT_TEXT, &args.common.dir, "DIR", "write all tables there", 0, 0},
    {"method", 0, OPT_TEXT, &args.method, "gap|displacement|imaginary", "how to solve", 0, 0},
    {"step", 0, OPT_TEXT, &args.step, "constant|unit|span", "of --method imaginary", 0, 0},
    {"rope", 0, OPT_TEXT, &args.rope, "auto|chain|catenary",
     "chain: straight elements, catenary: continuous", 0, 0},
    {"verify", 0, OPT_FLAG, &args.verify, NULL, "solve by a second method and compare", 0, 0},
    {"stiffness", 0, OPT_TEXT, &args.stiffness, "NODES",
     "stiffness of these nodes (a,b,...) or of a body (body), condensed on the rest", 0, 0},
    {"about", 0, OPT_TEXT, &args.about, "X,Y,Z", "--stiffness: of a rigid body that carries them",
     0, 0},
    {"body", 0, OPT_TEXT, &args.body, "NAME", "the body of --move, --moves and --stiffness body", 0,
     0},
    {"move", 0, OPT_TEXT, &args.move, "DX,DY,DZ,RX,RY,RZ", "move a body first", 0, 0},
    {"moves", 0, OPT_TEXT, &args.moves, "FILE", "restoring curve: a row for each move in the table",
     0, 0},
    {"pretension", 0, OPT_LIST, &args.pretension, "ROPE=TENSION",
     "find the length or anchor that gives a rope this tension", 0, 0},
    {"by", 0, OPT_TEXT, &args.by, "length|anchor", "--pretension: what gives way", 0, 0},
    {"lint", 0, OPT_FLAG, &args.lint, NULL, "only check the system", 0, 0},
    {"write-deck", 0, OPT_TEXT, &args.write_deck, "FILE",
     "write a MoorDyn v2 deck with the found positions", 0, 0},
    OPT_COMMON(&args.common),
};

static const struct opt_tool tool = {"gapnet", "SYSTEM",
                                     "Equilibrium of systems of ropes and nets by the gap method.",
                                     options, system_name_keys};

static int is_body_stiffness(void)
{
    return args.stiffness && strcmp(args.stiffness, "body") == 0;
}

static struct system_case c;
static struct system all;
static struct net_state state;

/* An option is a shorter way to say a key of [solve]; --set goes first. */
static void set_word(const char *option, const char *words, const char *given, int *to)
{
    int at = 0;

    if (!given)
        return;
    for (const char *p = words; *p; p += strcspn(p, " "), p += *p == ' ', at++)
        if (strcspn(p, " ") == strlen(given) && strncmp(p, given, strlen(given)) == 0) {
            *to = at;
            return;
        }
    die(SW_USAGE, "option --%s: '%s' is not one of: %s", option, given, words);
}

static void load(const char *path)
{
    struct why why;

    must(system_case_load(path, &args.common.sets, &c, &why), &why);
    set_word("method", "gap displacement imaginary", args.method, &c.method);
    set_word("rope", "auto chain catenary", args.rope, &c.rope);
    set_word("step", "constant unit span", args.step, &c.pull);
    if (args.common.print_case) {
        struct out o;

        must(out_open(&o, args.common.out, &why), &why);
        system_case_print(&c, &o);
        must(out_close(&o, &why), &why);
        exit(0);
    }
    must(system_load(path, &c, &all, &why), &why);
    for (int i = 0; i < all.notes; i++)
        (all.note[i].warns ? warn : note)("%s", all.note[i].text);
}

static struct net_options solver_options(int method)
{
    return (struct net_options){.method = (enum net_method)method,
                                .start = (enum net_stiffness)c.start,
                                .start_steps = c.start_steps,
                                .pull = (enum net_pull)c.pull,
                                .split = SPLIT * c.elements,
                                .hold = c.drag == DRAG_HOLD,
                                .tolerance = c.tolerance,
                                .steps = c.steps};
}

static const char *method_name(int method)
{
    static const char *const name[] = {"gap", "displacement", "imaginary"};

    return name[method];
}

static const char *node_name(int i)
{
    return i >= 0 ? system_node(&all, i) : "(a joint)";
}

/* Words for a system that a method did not solve. */
static void explain(enum status s, int method, const struct net_state *p, struct why *why)
{
    int worst = -1;
    double unbalance = s == SW_NOCONV ? net_unbalance(&all, p, &worst) : 0;
    const struct net_step *last = s == SW_NOCONV ? &p->step[p->steps] : NULL;

    if (s == SW_ADMISSIBLE && method == NET_IMAGINARY)
        fail(why, s,
             "method imaginary needs a system without closed parts, bars, springs, floats, bed, "
             "current and nodes that are held in some directions only");
    else if (s == SW_ADMISSIBLE)
        fail(why, s, "method displacement needs ropes of elements: take --rope chain");
    else if (s == SW_INDEFINITE)
        fail(why, s, "a mechanism: nothing holds node '%s' where it is", node_name(p->worst));
    else if (s == SW_NOCONV && p->adrift > c.tolerance)
        fail(why, s, "a free body finds no rest: %.3g of the largest tension or weight is missing",
             p->adrift);
    else if (s == SW_NOCONV)
        fail(why, s,
             "not solved in %d steps: the largest gap is %.3g of the system's size, the largest "
             "residual %.3g of the largest tension, at node '%s'",
             p->steps, last->largest_gap,
             fmax(unbalance, p->scale > 0 ? last->residual / p->scale : 0), node_name(worst));
    else
        fail(why, s, "%s", status_text(s));
}

static void tell(const char *text)
{
    struct why why;

    fail(&why, SW_FORMAT, "%s", text);
    report(&why);
}

static void doubt(const char *text)
{
    warn("%s", text);
}

/* Largest distance between the nodes of the solution and those of another method [m]. */
static double verify(void)
{
    int other = c.method == NET_GAP ? NET_DISPLACEMENT : NET_GAP;
    struct net_options o = solver_options(other);
    struct net_state second;
    struct why why;
    double most = 0;
    struct net again = all.net; /* ropes keep some of their state */
    enum status s;

    again.rope = malloc(sizeof *again.rope * (size_t)again.m);
    if (!again.rope)
        die(SW_NOMEM, "%s", status_text(SW_NOMEM));
    memcpy(again.rope, all.net.rope, sizeof *again.rope * (size_t)again.m);
    s = net_solve(&again, &o, &second);
    free(again.rope);

    if (s != SW_OK) {
        explain(s, other, &second, &why);
        die(s, "--verify, method %s: %s", method_name(other), why.text);
    }
    for (int i = 0; i < 3 * all.net.n; i++)
        most = fmax(most, fabs(second.x[i] - state.x[i]));
    net_state_free(&second);
    note("%s and %s differ by %.3g m", method_name(c.method), method_name(other), most);
    if (most > 1e-6 * state.size)
        warn("another equilibrium was found: method %s puts nodes up to %.6g m away",
             method_name(other), most);
    return most;
}

static void remark(void)
{
    struct net_doubt d;
    struct why why;

    must(net_within_tables(&all, &state, &why), &why);
    must(net_doubt_new(&all, &d, &why), &why);
    net_doubt_tell(&d, &state, "");
    net_doubt_free(&d);
}

/* The body that options speak of. */
static int chosen_body(const char *option)
{
    struct why why;
    int body;

    if (net_choose_body(&all, args.body, &body, &why) != SW_OK)
        die(SW_USAGE, "option --%s: %s", option, why.text);
    return body;
}

/* What --stiffness is about: nodes, and of a body the point. */
static int choose(int *ret, double about[3])
{
    struct why why;
    int k = 0, body;

    if (!is_body_stiffness() && net_choose_nodes(&all, args.stiffness, ret, &k, &why) != SW_OK)
        die(SW_USAGE, "option --stiffness: %s", why.text);
    if (args.about && numbers_read(args.about, 3, about, &why) != SW_OK)
        die(SW_USAGE, "option --about: %s", why.text);
    if (!is_body_stiffness())
        return k;
    body = chosen_body("stiffness");
    for (int i = 0; i < all.net.n; i++)
        if (all.net.node[i].body == body + 1)
            ret[k++] = i;
    if (!args.about)
        memcpy(about, all.net.body[body].x, 3 * sizeof *about);
    return k;
}

static void print_stiffness(void)
{
    int *chosen = malloc(sizeof *chosen * (size_t)all.net.n), k;
    int of_body = args.about || is_body_stiffness();
    double *K, about[3];
    struct out o;
    struct why why;
    enum status s;

    if (!chosen)
        die(SW_NOMEM, "%s", status_text(SW_NOMEM));
    k = choose(chosen, about);
    K = calloc(of_body ? 36 : 9 * (size_t)k * (size_t)k + 1, sizeof *K);
    if (!K)
        die(SW_NOMEM, "%s", status_text(SW_NOMEM));
    s = of_body ? net_body_stiffness(&all.net, &state, chosen, k, about, K)
                : net_stiffness(&all.net, &state, chosen, k, K);
    if (s != SW_OK)
        die(s, "stiffness: %s", status_text(s));
    if (args.common.dir) {
        must(net_write_stiffness(args.common.dir, &all, chosen, k, of_body, K, &why), &why);
    } else {
        must(out_open(&o, args.common.out, &why), &why);
        if (of_body)
            net_print_body(K, &o);
        else
            net_print_stiffness(&all, chosen, k, K, &o);
        must(out_close(&o, &why), &why);
    }
    free(chosen);
    free(K);
}

/* --move: the body, before anything is solved. */
static void move_body(void)
{
    double move[6];
    struct net_body from;
    struct why why;
    int body;

    if (numbers_read(args.move, 6, move, &why) != SW_OK)
        die(SW_USAGE, "option --move: %s", why.text);
    body = chosen_body("move");
    from = all.net.body[body];
    if (!from.held)
        die(SW_USAGE, "option --move: body '%s' is free", roll_name(&all.bodies, body));
    net_move_body(&all, body, &from, move);
    must(system_judge_bed(&all, &why), &why);
}

/* --moves: the curve in place of all else. */
static int print_curve(const struct net_options *solver)
{
    struct out o;
    struct why why;
    int failed, body = chosen_body("moves");

    must(out_open(&o, args.common.out, &why), &why);
    must(net_print_curve(&all, solver, body, args.moves, &o, &failed, &why), &why);
    must(out_close(&o, &why), &why);
    return failed > 0;
}

/* Whether the state is a balance, though not the wanted one. */
static int is_balance(void)
{
    return state.step && state.step[state.steps].largest_gap <= c.tolerance &&
           state.adrift <= c.tolerance;
}

/* --pretension: the system with what it needs. */
static enum status tune(const struct net_options *o, struct why *why)
{
    int by = 0;
    struct net_target *target = calloc((size_t)args.pretension.n, sizeof *target);
    enum status s;

    if (!target)
        die(SW_NOMEM, "%s", status_text(SW_NOMEM));
    set_word("by", "length anchor", args.by, &by);
    for (int i = 0; i < args.pretension.n; i++)
        if (net_take_target(&all, args.pretension.item[i], by, &target[i], why) != SW_OK)
            die(SW_USAGE, "option --pretension: %s", why->text);
    s = net_tune(&all.net, o, target, args.pretension.n, &state);
    if (s == SW_NOCONV && is_balance())
        net_explain_targets(&all, &state, target, args.pretension.n, why);
    else if (s != SW_OK)
        explain(s, c.method, &state, why);
    free(target);
    return s;
}

/* All of it: the state, or why there is none. */
static enum status solve(const struct net_options *o, struct why *why)
{
    enum status s = args.pretension.n > 0 ? tune(o, why) : net_settle(&all.net, o, &state);

    if (s != SW_OK && args.pretension.n == 0)
        explain(s, c.method, &state, why);
    return s == SW_OK ? system_judge_bed(&all, why) : s; /* free bodies may be there now */
}

/* Whether the deck takes the place of the table of nodes. */
static int deck_on_stdout(void)
{
    return args.write_deck && strcmp(args.write_deck, "-") == 0 && !args.common.out;
}

static void print_results(const struct net_report *r)
{
    struct out o;
    struct why why;

    if (args.common.dir) {
        must(net_write(args.common.dir, &all, &state, r, &why), &why);
    } else if (!args.stiffness && !deck_on_stdout()) {
        must(out_open(&o, args.common.out, &why), &why);
        must(net_print_nodes(&all, &state, &o, &why), &why);
        must(out_close(&o, &why), &why);
    }
}

/* Ready beside its name, since it may be refused; it appears when all else is written. */
static void write_deck(struct out *o)
{
    struct why why;

    if (!args.write_deck)
        return;
    must(out_open(o, args.write_deck, &why), &why);
    must(deck_write(&all, &state, o, &why), &why);
    must(out_finish(o, &why), &why);
}

static void publish_deck(struct out *o)
{
    struct why why;

    if (!args.write_deck)
        return;
    must(out_rename(o, &why), &why);
    if (all.sea.current.n > 0)
        warn("%s: the current is not in it; set tables.current with it", args.write_deck);
}

int main(int argc, char **argv)
{
    int operand = start_options(&tool, &args.common, argc, argv);
    struct net_report r = {.difference = NAN};
    struct net_options o;
    struct out deck;
    struct why why;

    if (operand != argc - 1)
        opt_usage(&tool);
    if (args.about && !args.stiffness)
        die(SW_USAGE, "option --about belongs to --stiffness");
    if (args.body && !args.move && !args.moves && !is_body_stiffness())
        die(SW_USAGE, "option --body belongs to --move, --moves and --stiffness body");
    if (args.by && args.pretension.n == 0)
        die(SW_USAGE, "option --by belongs to --pretension");
    if (args.moves && (args.common.dir || args.stiffness || args.write_deck || args.verify))
        die(SW_USAGE, "option --moves prints the curve alone");
    if (args.common.out && args.common.dir)
        die(SW_USAGE, "options -o and -d: all tables go to the directory");
    if (deck_on_stdout() && args.stiffness && !args.common.dir)
        die(SW_USAGE, "options --write-deck - and --stiffness: one of them needs a file");
    load(argv[operand]);
    if (args.lint)
        return system_lint(&all, 0, tell) > 0;
    system_lint(&all, 1, doubt);
    o = solver_options(c.method);
    r.method = method_name(c.method);
    if (args.move)
        move_body();
    r.status = solve(&o, &why);
    if (r.status != SW_OK) {
        if (r.status == SW_NOCONV && args.common.dir)
            print_results(&r); /* how far it came */
        must(r.status, &why);
    }
    if (args.moves)
        return print_curve(&o);
    remark();
    if (args.verify)
        r.difference = verify();
    write_deck(&deck);
    print_results(&r);
    if (args.stiffness)
        print_stiffness();
    publish_deck(&deck);
    net_state_free(&state);
    system_free(&all);
    opt_list_free(&args.common.sets);
    return 0;
}
