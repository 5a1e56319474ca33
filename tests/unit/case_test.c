/* Case files: defaults, what is resolved, printing and reading again, --set, each refusal. */
#include "textfile.h"

#include "form/cable.h"
#include "num/mem.h"
#include "phys/modes.h"

#define BASE                                                                                       \
    "[cable]\nunstressed_length = 10\nmass_per_length = 2\naxial_stiffness = 1e6\n"                \
    "[supports]\nspan = 10.01\n"

static struct why why;
static struct cable_case c, again;

/* Read text with up to four --set assignments, the first NULL ends them. */
static enum status read_with(const char *text, const char *const set[4], struct cable_case *ret)
{
    const char *item[4];
    struct opt_list sets = {item, 0};
    FILE *f = file_with(text, strlen(text));
    enum status s;

    while (sets.n < 4 && set && set[sets.n]) {
        item[sets.n] = set[sets.n];
        sets.n++;
    }
    strcpy(why.text, "nothing");
    case_free(ret); /* of the last time */
    s = case_read(f, "test", &sets, ret, &why);
    fclose(f);
    return s;
}

static void read_good(const char *text, const char *const set[4])
{
    if (read_with(text, set, &c) != SW_OK)
        print_error("%s\n", why.text);
    assert_string_equal(why.text, "nothing");
}

#define good(text, ...) read_good(text, (const char *const[4]){__VA_ARGS__})

/* The case as printed; to be freed. */
static char *printed(const struct cable_case *p)
{
    char *text = NULL;
    size_t size;
    struct out o = {.f = open_memstream(&text, &size), .slot = -1};

    assert_non_null(o.f);
    case_print(p, &o);
    fclose(o.f);
    return text;
}

/* c printed is a case that prints the same, of the same model. */
static void fixed_point(void)
{
    char *once = printed(&c), *twice;

    if (read_with(once, NULL, &again) != SW_OK)
        print_error("%s\n%s", why.text, once);
    assert_string_equal(why.text, "nothing");
    twice = printed(&again);
    assert_string_equal(once, twice);
    assert_null(case_model_difference(&c, &again));
    free(once);
    free(twice);
}

static void refuse_with(const char *text, const char *const set[4], enum status wanted,
                        const char *message)
{
    assert_int_equal(read_with(text, set, &c), wanted);
    assert_string_equal(why.text, message);
}

#define bad(text, message) refuse_with(text, NULL, SW_FORMAT, message)
#define bad_set(message, ...)                                                                      \
    refuse_with(BASE, (const char *const[4]){__VA_ARGS__}, SW_USAGE, message)

static void defaults(void **state)
{
    char *text;
    (void)state;

    good(BASE, NULL);
    assert_true(c.bare.drop == 0 && c.bare.g == 9.81 && c.elements == 20 && c.law == LAW_HOOKE);
    assert_true(isnan(c.youngs_modulus) && isnan(c.area) && c.bare.EA == 1e6);
    assert_true(c.alpha == 0 && c.beta == 0);
    assert_int_equal(c.n_motions, 0);
    assert_int_equal(c.n_disturbances, 0);
    assert_true(isnan(c.time.end) && c.time.scheme == 0 && c.time.step == 0);
    assert_int_equal(c.time.start, START_STATIC);
    assert_true(c.time.n_probes == 1 && c.time.probe[0] == 0.5);
    assert_int_equal(c.terms, 3);
    c.time.output_every = 0.25;
    text = printed(&c);
    assert_string_equal(text, "[cable]\nunstressed_length = 10\nmass_per_length = 2\n"
                              "axial_stiffness = 1000000\n[supports]\nspan = 10.01\n"
                              "drop = 0\n"
                              "[gravity]\nacceleration = 9.81\n"
                              "[load]\nice_mass_per_length = 0\nwind = 0 0 0\n"
                              "temperature_change = 0\nexpansion_coefficient = 0\n"
                              "[mesh]\nelements = 20\nlaw = hooke\n"
                              "[damping]\nalpha = 0\nbeta = 0\n"
                              "[time]\nscheme = central\nstep = auto\nstart = static\n"
                              "output_every = 0.25\nprobes = 0.5\n"
                              "[nonlinear]\nterms = 3\n"
                              "[steady]\ntolerance = 0.0001\nperiods = 20\n"
                              "[stability]\nmethod = bolotin\ntheory = indifference\n"
                              "quadratic = no\nground = damped\nmodes = 1 2\nharmonics = 9\n"
                              "ratio_start = 0.4\nratio_end = 1.2\nratio_step = 0.005\n"
                              "reference_mode = 1\namplitude_start = 0\namplitude_end = 1\n"
                              "amplitude_step = 0.001\n");
    free(text);
}

/* Rows for each 1/50 of the shortest excitation period, else of the first lateral period. */
static void output_interval(void **state)
{
    static const char motions[] = BASE "[motion a]\namplitude = 1 0 0\nomega = 3\n"
                                       "[motion b]\namplitude = 1 0 0\nomega = 5\n";
    struct line line;
    (void)state;

    good(motions, NULL);
    near_rel(c.time.output_every, 2 * PI / 5 / 50, 1e-15);
    good(motions, "time.output_every=0.125");
    near_rel(c.time.output_every, 0.125, 0);
    good(BASE, NULL);
    assert_int_equal(line_solve(&c.cable, &line), SW_OK); /* a string: omega = pi/l sqrt(H/m) */
    near_rel(c.time.output_every, 2 * c.bare.span / 50 / sqrt(line.H / 2 * 10.01 / 10), 1e-14);
    good(BASE, "motion.amplitude=0 0 0", "motion.omega=1e-9");
    fixed_point();
    good(BASE, "cable.unstressed_length=1e9", "supports.span=1e-6", "gravity.acceleration=1e-300");
    fixed_point(); /* a default outside of the key's range is moved to its end */
}

static void stiffness_both_ways(void **state)
{
    static const char text[] = "[cable]\nunstressed_length = 10\nmass_per_length = 2\n"
                               "youngs_modulus = 2e11\narea = 2.5e-4\n[supports]\nspan = 10.01\n";
    char *shown;
    (void)state;

    good(text, NULL);
    near_rel(c.bare.EA, 5e7, 0);
    fixed_point();
    shown = printed(&c);
    assert_non_null(strstr(shown, "youngs_modulus = 200000000000\narea = 0.00025\n"));
    assert_null(strstr(shown, "axial_stiffness"));
    free(shown);
    assert_int_equal(read_with(text, NULL, &again), SW_OK);
    good(text, "cable.youngs_modulus=", "cable.area=", "cable.axial_stiffness=5e7");
    assert_null(case_model_difference(&c, &again));
}

/* zeta_i = alpha/(2 omega_i) + beta omega_i/2. */
static void two_point_fit(void **state)
{
    static const struct {
        const char *zeta, *omega;
        double z[2], w[2];
    } table[] = {
        {"damping.zeta=0.02 0.03", "damping.omega=3 50", {0.02, 0.03}, {3, 50}},
        {"damping.zeta=0.03 0.02", "damping.omega=50 3", {0.03, 0.02}, {50, 3}},
        {"damping.zeta=0 0", "damping.omega=1 2", {0, 0}, {1, 2}},
        {"damping.zeta=0.01 0.01", "damping.omega=1 1.001", {0.01, 0.01}, {1, 1.001}},
    };
    (void)state;

    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        good(BASE, table[i].zeta, table[i].omega);
        for (int k = 0; k < 2; k++)
            near_abs(c.alpha / 2 / table[i].w[k] + c.beta * table[i].w[k] / 2, table[i].z[k],
                     1e-13 * table[i].z[k]);
        assert_true(isnan(c.zeta[0]) && isnan(c.zeta_omega[1]));
        fixed_point();
    }
    good(BASE, "damping.alpha=0.1");
    assert_true(c.alpha == 0.1 && c.beta == 0);
}

/* Ratios that beta or alpha alone explains: the other one is 0, whatever round-off says. */
static void one_sided_fit(void **state)
{
    uint64_t seed = 4711;
    (void)state;

    for (int i = 0; i < 2000; i++) {
        double w[2] = {log_uniform(&seed, 0.1, 1e3), log_uniform(&seed, 0.1, 1e3)};
        double k = log_uniform(&seed, 1e-6, 1e-2);
        char zeta[100], omega[100];

        snprintf(omega, sizeof omega, "damping.omega=%.17g %.17g", w[0], w[1]);
        snprintf(zeta, sizeof zeta, "damping.zeta=%.17g %.17g", k * w[0], k * w[1]);
        good(BASE, zeta, omega);
        near_rel(c.beta, 2 * k, 1e-9);
        below(c.alpha, 1e-12 * k * w[0] * w[0] + 1e-12 * k * w[1] * w[1]);
        snprintf(zeta, sizeof zeta, "damping.zeta=%.17g %.17g", k / w[0], k / w[1]);
        good(BASE, zeta, omega);
        near_rel(c.alpha, 2 * k, 1e-9);
    }
}

static void motions(void **state)
{
    (void)state;
    good(BASE "[motion]\namplitude = 1 2 3\nomega = 4\n"
              "[motion deck  east]\nsupport = left\namplitude = 0 0 -1\nomega = 5\n"
              "phase = 0.5\nramp = 2\n"
              "[motion b]\namplitude = 1 0 0\nomega = 6\nphase = 1 2 -3\n",
         NULL);
    assert_int_equal(c.n_motions, 3);
    assert_string_equal(c.motion_label[0], "motion");
    assert_string_equal(c.motion_label[1], "motion deck east");
    assert_string_equal(c.motion_label[2], "motion b");
    assert_int_equal(c.motion[0].support, SUPPORT_RIGHT);
    assert_int_equal(c.motion[1].support, SUPPORT_LEFT);
    assert_true(c.motion[0].amplitude[1] == 2 && c.motion[0].ramp == 0);
    for (int i = 0; i < 3; i++) {
        assert_true(c.motion[0].phase[i] == 0);
        assert_true(c.motion[1].phase[i] == 0.5);
    }
    assert_true(c.motion[2].phase[0] == 1 && c.motion[2].phase[2] == -3);
    assert_true(c.motion[1].ramp == 2 && c.motion[1].omega == 5);
    fixed_point();
}

/* Labels as long as they may be, told apart by the last byte. */
static void long_labels(void **state)
{
    char *label = repeat('x', 55), text[512];
    (void)state;

    snprintf(text, sizeof text,
             BASE "[motion %s1]\namplitude = 1 0 0\nomega = 4\n"
                  "[motion %s2]\namplitude = 2 0 0\nomega = 5\n",
             label, label);
    good(text, NULL);
    assert_int_equal(c.n_motions, 2);
    assert_true(c.motion[0].omega == 4 && c.motion[1].omega == 5);
    fixed_point();
    snprintf(text, sizeof text, BASE "[motion %s12]\namplitude = 1 0 0\nomega = 4\n", label);
    bad(text, "test:7: the label is longer than 63 bytes");
    free(label);
}

static void any_number_of_motions(void **state)
{
    char text[8192];
    size_t used = (size_t)snprintf(text, sizeof text, "%s", BASE);
    (void)state;

    for (int i = 1; i <= 60; i++)
        used += (size_t)snprintf(text + used, sizeof text - used,
                                 "[motion %d]\namplitude = 1 0 0\nomega = %d\n", i, i);
    good(text, NULL);
    assert_int_equal(c.n_motions, 60);
    assert_true(c.motion[59].omega == 60);
    fixed_point();
}

static void disturbances(void **state)
{
    (void)state;
    good(BASE "[disturbance]\nmode = 3\namplitude = 0.1\n"
              "[disturbance kick]\ntime = 2\nnode = 19\namplitude = 0 0 1\nkind = velocity\n",
         NULL);
    assert_int_equal(c.n_disturbances, 2);
    assert_true(c.disturbance[0].mode == 3 && c.disturbance[0].node == -1);
    assert_true(c.disturbance[0].time == 0 && c.disturbance[0].kind == KICK_DISPLACEMENT);
    assert_true(c.disturbance[1].mode == -1 && c.disturbance[1].node == 19);
    assert_true(c.disturbance[1].time == 2 && c.disturbance[1].kind == KICK_VELOCITY);
    assert_true(c.disturbance[1].amplitude[2] == 1);
    fixed_point();
}

static void times(void **state)
{
    (void)state;
    good(BASE "[time]\nend = 3\nstep = 1e-5\nprobes = 0 0.25 1\nstart = mode 120 -0.5\n", NULL);
    assert_true(c.time.end == 3 && c.time.step == 1e-5 && c.time.n_probes == 3);
    assert_true(c.time.start == START_MODE && c.time.start_mode == 120);
    assert_true(c.time.start_amplitude == -0.5);
    fixed_point();
    good(BASE, "time.start=rest", "motion.amplitude=1 0 0", "motion.omega=1", "motion.ramp=1");
    assert_int_equal(c.time.start, START_REST);
    fixed_point();
    good(BASE, "time.start=rest");
    good(BASE, "time.step=auto");
    assert_true(c.time.step == 0);
}

/* As many probes as fit; a line that would be too long to be read again is refused. */
static void probes(void **state)
{
    static const char wide[] = "[time]\nprobes = 1e-5 1e-5 1e-5 1e-5 1e-5 1e-5 1e-5 1e-5 1e-5 1e-5 "
                               "1e-5 1e-5 1e-5 1e-5 1e-5 1e-5 1e-5 1e-5 1e-5 1e-5 1e-5 1e-5 1e-5";
    char text[512];
    (void)state;

    snprintf(text, sizeof text, "%s%s\n", BASE, wide); /* 23 of 7 digits: 8 + 23 * 8 = 192 bytes */
    good(text, NULL);
    assert_int_equal(c.time.n_probes, 23);
    fixed_point();
    snprintf(text, sizeof text, "%s%s 1e-5\n", BASE, wide);
    bad(text, "test:8: probes: the list, printed, is longer than 198 bytes");
    snprintf(text, sizeof text, "%s[time]\nprobes =", BASE);
    for (int i = 0; i < 95; i++)
        strcat(text, " 0");
    good(text, NULL);
    assert_int_equal(c.time.n_probes, 95);
    fixed_point();
    strcat(text, " 1");
    bad(text, "test:8: the line is longer than 198 bytes");
}

static void sets(void **state)
{
    (void)state;
    good(BASE, "supports.drop=3", "mesh.elements=7", "cable.axial_stiffness=5", "mesh.law=printed");
    assert_true(c.bare.drop == 3 && c.elements == 7 && c.bare.EA == 5 && c.law == LAW_PRINTED);
    good(BASE "[time]\nend = 3\n", "time.end=");
    assert_true(isnan(c.time.end));
    good(BASE, "mesh.elements=7", "mesh.elements=8");
    assert_int_equal(c.elements, 8);
    good(BASE, "mesh.elements=7", "mesh.elements=");
    assert_int_equal(c.elements, 20);
    good(BASE, "motion deck.omega=3", "motion deck.amplitude=1 0 0");
    assert_int_equal(c.n_motions, 1);
    assert_string_equal(c.motion_label[0], "motion deck");
    fixed_point();
    good("[supports]\n", "cable.unstressed_length=1", "cable.mass_per_length=1",
         "cable.axial_stiffness=1e9", "supports.span=1");
}

/* -0 and +0 are the same, and so are values written in different ways. */
static void models(void **state)
{
    static const struct {
        const char *set, *key;
    } table[] = {
        {"cable.unstressed_length=10.00000000000001", "cable.unstressed_length"},
        {"cable.mass_per_length=3", "cable.mass_per_length"},
        {"cable.axial_stiffness=2e6", "cable.axial_stiffness"},
        {"supports.span=10.02", "supports.span"},
        {"supports.drop=-1", "supports.drop"},
        {"gravity.acceleration=9.82", "gravity.acceleration"},
        {"load.ice_mass_per_length=1", "load.ice_mass_per_length"},
        {"load.wind=1 0 0", "load.wind"},
        {"load.wind=0 1 0", "load.wind"},
        {"load.wind=0 0 -1", "load.wind"},
        {"load.temperature_change=1", "load.temperature_change"},
        {"load.expansion_coefficient=1e-5", "load.expansion_coefficient"},
        {"mesh.elements=21", "mesh.elements"},
        {"mesh.law=thesis", "mesh.law"},
    };
    (void)state;

    assert_int_equal(read_with(BASE, NULL, &again), SW_OK);
    good(BASE, "supports.drop=-0", "mesh.elements=020", "cable.axial_stiffness=1000000.0");
    assert_null(case_model_difference(&again, &c));
    good(BASE, "damping.alpha=1", "time.end=3", "nonlinear.terms=0", "time.probes=0.1");
    assert_null(case_model_difference(&again, &c));
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        good(BASE, table[i].set);
        assert_string_equal(case_model_difference(&again, &c), table[i].key);
        assert_string_equal(case_model_difference(&c, &again), table[i].key);
    }
}

static void names(void **state)
{
    (void)state;
    bad("", "test: is empty; a case with at least [cable] and [supports] is expected");
    bad("[cable]\n", "test: is empty; a case with at least [cable] and [supports] is expected");
    bad(BASE "\n[rope]\n", "test:8: unknown section [rope]");
    bad(BASE "[cables]\nspan = 1\n", "test:7: unknown section [cables]");
    bad(BASE "[Cable]\narea = 1\n", "test:7: unknown section [Cable]");
    bad(BASE "# c\n[mesh]\nelement = 1\n", "test:9: unknown key 'element' in [mesh]");
    bad(BASE "[motion a]\nspan = 1\n", "test:8: unknown key 'span' in [motion a]");
    bad(BASE "[mesh fine]\nelements = 3\n", "test:7: section [mesh fine] takes no label");
    bad(BASE "span = 11\n", "test:7: [supports] span was given in line 6 already");
    bad_set("--set rope: unknown section [rope]", "rope.length=1");
    bad_set("--set cable.length: unknown key 'length' in [cable]", "cable.length=1");
    bad_set("--set mesh fine: section [mesh fine] takes no label", "mesh fine.elements=3");
    bad_set("--set span=3: expected SECTION.KEY=VALUE", "span=3");
}

static void values(void **state)
{
    (void)state;
    bad(BASE "[mesh]\n\nelements = 1.5\n",
        "test:9: elements: '1.5': not a whole number (expected 1 to 1000000)");
    bad(BASE "[mesh]\nelements = 0\n",
        "test:8: elements: '0': the number is too small (expected 1 to 1000000)");
    bad(BASE "[mesh]\nelements = 1000001\n",
        "test:8: elements: '1000001': the number is too large (expected 1 to 1000000)");
    bad(BASE "[mesh]\nlaw = Hooke\n", "test:8: law: 'Hooke' is not one of: hooke thesis printed");
    bad(BASE "[mesh]\nlaw = hooke thesis\n",
        "test:8: law: 'hooke thesis' is not one of: hooke thesis printed");
    bad(BASE "drop = 1,5\n", "test:7: drop: '1,5': a decimal point is expected, not a comma");
    bad(BASE "drop = 1 m\n", "test:7: drop: 'm' is no number; units are fixed");
    bad(BASE "drop = 1m\n", "test:7: drop: '1m': not a number");
    bad(BASE "drop = nan\n", "test:7: drop: 'nan': not a number");
    bad(BASE "drop = -inf\n", "test:7: drop: '-inf': not a number");
    bad(BASE "drop = 1e400\n", "test:7: drop: '1e400': the number is too large");
    bad(BASE "drop = -2e9\n", "test:7: drop: -2e9 is outside of -1e+09 to 1e+09");
    bad(BASE "[gravity]\nacceleration = -1\n", "test:8: acceleration: -1 is outside of 0 to 1e+06");
    bad(BASE "[damping]\nzeta = 0.1\nomega = 1 2\n", "test:8: zeta: 2 numbers are expected");
    bad(BASE "[time]\nstep = automatic\n", "test:8: step: 'automatic': not a number");
    bad(BASE "[time]\nscheme = newmark\n",
        "test:8: scheme: 'newmark' is not one of: central alpha");
    bad_set("--set supports.drop: '1,5': a decimal point is expected, not a comma",
            "supports.drop=1,5");
    bad_set("--set supports.span: 0 is outside of 1e-06 to 1e+09", "supports.span=0");
}

static void missing(void **state)
{
    static const char one[] =
        "test: [cable] axial_stiffness: give either axial_stiffness or youngs_modulus and area";
    static const char length[] = "test: [cable] unstressed_length: is missing, and nothing that it "
                                 "follows from is given";
    (void)state;

    bad("[mesh]\nelements = 2\n", "test: [cable] mass_per_length: is missing");
    bad("[cable]\nmass_per_length = 1\n", "test: [supports] span: is missing");
    refuse_with(BASE, (const char *const[4]){"cable.unstressed_length="}, SW_FORMAT, length);
    refuse_with(BASE, (const char *const[4]){"cable.axial_stiffness="}, SW_FORMAT, one);
    refuse_with(BASE, (const char *const[4]){"cable.axial_stiffness=", "cable.area=1"}, SW_FORMAT,
                one);
    bad("[cable]\nunstressed_length = 10\nmass_per_length = 2\naxial_stiffness = 1e6\narea = 1\n"
        "[supports]\nspan = 10.01\n",
        "test:4: axial_stiffness: give either axial_stiffness or youngs_modulus and area");
    bad("[cable]\nunstressed_length = 10\nmass_per_length = 2\naxial_stiffness = 1e6\narea = 1\n"
        "youngs_modulus = 1\n[supports]\nspan = 10.01\n",
        "test:4: axial_stiffness: give either axial_stiffness or youngs_modulus and area");
    refuse_with(BASE, (const char *const[4]){"gravity.acceleration=0", "supports.span=10"},
                SW_ADMISSIBLE,
                "test: without gravity the chord must be longer than the unstressed length");
}

#define KNOWN "[cable]\nmass_per_length = 2\naxial_stiffness = 1e6\n[supports]\nspan = 10.01\n"

/* Each of the givens: the length takes its place, in the printed case, too. */
static void givens(void **state)
{
    static const char *const given[] = {"cable.horizontal_force=1000",
                                        "cable.midspan_tension=1000",
                                        "cable.tension_left=1000",
                                        "cable.tension_right=1000",
                                        "cable.sag=0.025",
                                        "cable.fundamental_frequency=1.1",
                                        "cable.frequency=1.1"};
    char *text;
    (void)state;

    for (size_t i = 0; i < sizeof given / sizeof *given; i++) {
        good(KNOWN, given[i], i == 6 ? "cable.mode=1" : NULL, "cable.plane=out");
        assert_true(c.found && c.bare.L0 > 9.9 && c.bare.L0 < 10.02);
        near_rel(c.cable.L0, c.bare.L0, 0);
        text = printed(&c);
        assert_int_equal(strncmp(text, "[cable]\nunstressed_length = ", 28), 0);
        for (const char *const *word = (const char *const[]){"force", "tension", "sag", "freq",
                                                             "\nmode =", "plane", "branch", NULL};
             *word; word++)
            assert_null(strstr(text, *word));
        free(text);
        fixed_point();
    }
    good(BASE, NULL);
    assert_false(c.found);
}

/* 160 N, 8 % above the least (0.7544 w l of the level catenary), is found on two cables; the tauter
 * one unless the slack one is asked for. */
static void branches(void **state)
{
    double taut;
    (void)state;

    good(KNOWN, "cable.tension_left=160");
    taut = c.bare.L0;
    good(KNOWN, "cable.tension_left=160", "cable.branch=taut");
    assert_true(c.bare.L0 == taut);
    good(KNOWN, "cable.tension_left=160", "cable.branch=slack");
    assert_true(c.bare.L0 > taut + 0.1);
    fixed_point();
    refuse_with(BASE, (const char *const[4]){"cable.branch=taut"}, SW_USAGE,
                "--set cable.branch: the unstressed length is given, which is one cable");
    refuse_with(KNOWN, (const char *const[4]){"cable.sag=0.1", "cable.branch=slack"}, SW_INFEASIBLE,
                "--set cable.sag: only one cable, the tauter one, has it");
}

/* The frequency is that of the case's own mesh, law, plane and mode. */
static void frequencies(void **state)
{
    static const struct {
        const char *mode, *plane, *law;
        int part, number;
    } row[] = {{"cable.mode=1", "cable.plane=out", "mesh.law=hooke", PART_LATERAL, 1},
               {"cable.mode=3", "cable.plane=out", "mesh.law=thesis", PART_LATERAL, 3},
               {"cable.mode=2", "cable.plane=in", "mesh.law=printed", PART_PLANE, 2},
               {"cable.mode=4", "cable.plane=in", "mesh.law=hooke", PART_PLANE, 4}};
    (void)state;

    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct model m;
        double omega = NAN;

        good(KNOWN "[cable]\nfrequency = 3.5\n[mesh]\nelements = 6\n", row[i].mode, row[i].plane,
             row[i].law);
        assert_int_equal(case_model(&c, &m), SW_OK);
        assert_int_equal(modes_of_part(&m, (enum part)row[i].part, row[i].number, &omega), SW_OK);
        near_rel(omega / (2 * PI), 3.5, 1e-9);
        model_free(&m);
    }
}

static void given_refusals(void **state)
{
    static const char one[] =
        "give exactly one of unstressed_length, horizontal_force, midspan_tension, tension_left, "
        "tension_right, sag, fundamental_frequency, frequency";
    char text[300];
    (void)state;

    snprintf(text, sizeof text, "test:8: sag: %s", one);
    bad(BASE "[cable]\nsag = 1\n", text);
    snprintf(text, sizeof text, "test:8: sag: %s", one);
    bad(KNOWN "[cable]\ntension_left = 3\nsag = 1\n", text);
    snprintf(text, sizeof text, "test:7: fundamental_frequency: %s", one);
    bad(KNOWN "[cable]\nfundamental_frequency = 3\nfrequency = 1\n", text);
    bad(BASE "[cable]\nmode = 1\n",
        "test:8: mode: tells of which mode frequency is; there is none");
    bad(KNOWN "[cable]\nfundamental_frequency = 3\nplane = in\n",
        "test:8: plane: tells of which mode frequency is; there is none");
    bad(KNOWN "[cable]\nfrequency = 3\nmode = 21\n",
        "test:8: mode: needs at least as many elements");
    bad(KNOWN "[cable]\nfrequency = 3\nplane = sideways\n",
        "test:8: plane: 'sideways' is not one of: out in");
    bad(KNOWN "[cable]\nsag = 0\n", "test:7: sag: 0 is outside of 1e-09 to 1e+09");
    refuse_with(KNOWN "[cable]\ntension_left = 10\n", NULL, SW_INFEASIBLE,
                "test:7: tension_left: no length gives 10; the least possible is 148.153855");
    refuse_with(
        KNOWN "[cable]\nmidspan_tension = 1e18\n", NULL, SW_INFEASIBLE,
        "test:7: midspan_tension: no length gives 1e+18; the cable would be stretched too far");
}

/* A length that no case may have is none. */
static void too_short(void **state)
{
    (void)state;
    refuse_with(
        "[cable]\nmass_per_length = 1\naxial_stiffness = 1\ntension_left = 500\n[supports]\n"
        "span = 1e-6\n",
        NULL, SW_INFEASIBLE,
        "test:4: tension_left: no length gives 500; the cable would be stretched too far");
}

/* Loads: the cable as given stays as it is, the one that hangs has them. */
static void loads(void **state)
{
    (void)state;
    good(BASE "[load]\nice_mass_per_length = 3\nwind = 0 0 15\ntemperature_change = -20\n"
              "expansion_coefficient = 1e-5\n",
         NULL);
    assert_true(c.bare.L0 == 10 && c.bare.mu == 2 && c.bare.g == 9.81 && c.bare.span == 10.01);
    near_rel(c.cable.L0, 10 * (1 - 2e-4), 1e-15);
    near_rel(c.cable.mu * c.cable.L0, 50, 1e-15);
    near_rel(c.cable.g, hypot(5 * 9.81, 15) / 5, 1e-15);
    assert_true(!axes_are_plain(&c.axes));
    fixed_point();
    good(BASE "[load]\nwind = 0 5 0\n", NULL);
    assert_true(axes_are_plain(&c.axes));
    good(KNOWN "[cable]\nsag = 0.1\n[load]\nwind = 1 2 3\ntemperature_change = 30\n"
               "expansion_coefficient = 1.2e-5\n",
         NULL);
    near_rel(c.cable.L0, c.bare.L0 * (1 + 3.6e-4), 1e-15);
    fixed_point();
    bad(BASE "[load]\nice_mass_per_length = -1\n",
        "test:8: ice_mass_per_length: -1 is outside of 0 to 1e+09");
    bad(BASE "[load]\nwind = 1 2\n", "test:8: wind: 3 numbers are expected");
    bad(BASE "[load]\ntemperature_change = 9000\nexpansion_coefficient = 1e-2\n",
        "test:8: temperature_change: changes the length by half or more; are the units right?");
    refuse_with(BASE "[load]\nwind = 3 0 0\n", (const char *const[4]){"gravity.acceleration=0"},
                SW_FORMAT, "test:8: wind: together with the weight acts along the chord");
}

static void dampers(void **state)
{
    (void)state;
    good(BASE "[damper]\nposition = 0.03\ndirection = 0 1 0\ncoefficient = 100\n"
              "[damper far end]\nposition = 0.97\ndirection = 0 0 -2\ncoefficient = 0\n",
         NULL);
    assert_int_equal(c.n_dampers, 2);
    assert_string_equal(c.damper_label[1], "damper far end");
    assert_true(c.damper[0].position == 0.03 && c.damper[0].direction[1] == 1);
    assert_true(c.damper[1].direction[2] == -2 && c.damper[1].coefficient == 0);
    fixed_point();
    bad(BASE "[damper]\ndirection = 0 1 0\ncoefficient = 1\n",
        "test: [damper] position: is missing");
    bad(BASE "[damper a]\nposition = 0\ndirection = 0 1 0\ncoefficient = 1\n",
        "test:8: position: must lie between the supports, above 0 and below 1");
    bad(BASE "[damper a]\nposition = 1.5\n", "test:8: position: 1.5 is outside of 0 to 1");
    bad(BASE "[damper a]\nposition = 0.5\ncoefficient = 1\n",
        "test: [damper a] direction: is missing");
    bad(BASE "[damper]\nposition = 0.5\ndirection = 0 0 0\ncoefficient = 1\n",
        "test:9: direction: must not be zero");
    bad(BASE "[damper]\nposition = 0.5\ndirection = 0 0 1\n",
        "test: [damper] coefficient: is missing");
    bad(BASE "[damper]\nposition = 0.5\ndirection = 0 0 1\ncoefficient = -1\n",
        "test:10: coefficient: -1 is outside of 0 to 1e+18");
}

/* Keys of the model, with and without their sections; the defaults of a table's row. */
static void model_keys(void **state)
{
    const char *item[] = {"cable.mass_per_length=3", "gravity.acceleration="};
    struct opt_list sets = {item, 2};
    (void)state;

    assert_string_equal(case_model_key("span")->section, "supports");
    assert_ptr_equal(case_model_key("span"), case_model_key("supports.span"));
    assert_string_equal(case_model_key("load.wind")->name, "wind");
    for (const char *const *name =
             (const char *const[]){"cable.span", "", ".", ".span", "supports.", "spa", "spans",
                                   "alpha", "damping.alpha", "time.end", "Span", "supports span",
                                   "supports.span.", "support.span", NULL};
         *name; name++)
        assert_null(case_model_key(*name));
    case_free(&c);
    assert_int_equal(case_model_defaults(&sets, &c, &why), SW_OK);
    assert_true(c.bare.mu == 3 && c.bare.g == 9.81 && c.elements == 20 && isnan(c.bare.L0));
    assert_true(isnan(c.bare.span) && c.bare.drop == 0 && isnan(c.known.value[GIVEN_SAG]));
    item[1] = "time.end=3";
    assert_int_equal(case_model_defaults(&sets, &c, &why), SW_USAGE);
    assert_string_equal(why.text, "--set time.end: belongs to no section of the model");
    item[1] = "cable.colour=3";
    assert_int_equal(case_model_defaults(&sets, &c, &why), SW_USAGE);
    item[1] = "cable.area=x";
    assert_int_equal(case_model_defaults(&sets, &c, &why), SW_USAGE);
    assert_string_equal(why.text, "--set cable.area: 'x': not a number");
}

static void damping(void **state)
{
    static const char feeds[] =
        "--set damping.zeta: these ratios need a negative alpha or beta, which would feed energy";
    (void)state;

    bad(BASE "[damping]\nzeta = 0.1 0.1\n", "test: [damping] omega: is missing");
    bad(BASE "[damping]\nomega = 1 2\n", "test: [damping] zeta: is missing");
    bad(BASE "[damping]\nomega = 1 2\nzeta = 0.1 0.1\nbeta = 0\n",
        "test:9: zeta: give either alpha and beta or zeta and omega (--set damping.alpha= removes "
        "a key)");
    bad(BASE "[damping]\nzeta = 0.1 0.1\nomega = 2 2\n", "test:9: omega: the two must differ");
    bad_set(feeds, "damping.zeta=0.1 0.0001", "damping.omega=1 100");
    bad_set(feeds, "damping.zeta=0.001 0.1", "damping.omega=1 10");
    bad_set("--set damping.zeta: these ratios need an alpha or beta above 1e+09",
            "damping.zeta=1000 1000", "damping.omega=1e9 9e8");
}

static void motion_refusals(void **state)
{
    (void)state;
    bad(BASE "[motion a]\nomega = 1\n", "test: [motion a] amplitude: is missing");
    bad(BASE "[motion]\namplitude = 1 0 0\n", "test: [motion] omega: is missing");
    bad(BASE "[motion]\namplitude = 1 0\nomega = 1\n", "test:8: amplitude: 3 numbers are expected");
    bad(BASE "[motion]\namplitude = 1 0 0\nomega = 1\nphase = 1 2\n",
        "test:10: phase: give one number or three");
    bad(BASE "[motion]\namplitude = 1 0 0 0\nomega = 1\n",
        "test:8: amplitude: more than 3 numbers");
    bad(BASE "[motion]\namplitude = 1 0 0\nomega = 0\n",
        "test:9: omega: 0 is outside of 1e-09 to 1e+09");
    bad(BASE "[motion]\nsupport = middle\n", "test:8: support: 'middle' is not one of: right left");
}

static void disturbance_refusals(void **state)
{
    (void)state;
    bad(BASE "[disturbance]\ntime = 1\n", "test: [disturbance] mode: give either mode or node");
    bad(BASE "[disturbance x]\nmode = 1\nnode = 1\n", "test:8: mode: give either mode or node");
    bad(BASE "[disturbance]\nmode = 1\n", "test: [disturbance] amplitude: is missing");
    bad(BASE "[disturbance]\nmode = 1\namplitude = 1 2\n",
        "test:9: amplitude: a mode takes one number");
    bad(BASE "[disturbance]\nnode = 1\namplitude = 1 2\n",
        "test:9: amplitude: a node takes three numbers");
    bad(BASE "[disturbance]\nmode = 121\namplitude = 1\n",
        "test:8: mode: the mesh has fewer modes (six an element)");
    bad(BASE "[disturbance]\nnode = 20\namplitude = 0 0 1\n",
        "test:8: node: must lie between the supports, 1 to elements - 1");
    bad(BASE "[disturbance]\nnode = 0\namplitude = 0 0 1\n",
        "test:8: node: '0': the number is too small (expected 1 to 1000000)");
}

/* [motion] by a file, [force], [wind]: either-or, defaults, printing. */
static void forces(void **state)
{
    (void)state;
    good(BASE "[motion quake]\nfile = quake.csv\n[motion]\namplitude = 1 0 0\nomega = 2\n", NULL);
    assert_int_equal(c.n_motions, 2);
    assert_string_equal(c.motion_section[0].file, "quake.csv");
    assert_true(c.motion[1].omega == 2 && c.motion_section[1].file[0] == '\0');
    near_rel(c.time.output_every, PI / 50, 1e-15);
    fixed_point();
    bad(BASE "[motion]\nfile = a.csv\nomega = 2\n",
        "test:8: file: give either a file, or amplitude and omega");
    good(BASE "[force a]\nposition = all\nvalue = 1 2 3\nomega = 5\n"
              "[force b]\nposition = 0.25\nfile = f.csv\n[load]\ntemperature_change = 100\n"
              "expansion_coefficient = 1e-5\n",
         NULL);
    assert_int_equal(c.n_forces, 2);
    assert_true(isnan(c.force[0].position) && c.force[0].phase == 0 && c.force[0].omega == 5);
    near_rel(c.force[0].value[2], 3 / 1.001, 1e-15); /* per metre before expansion */
    assert_true(c.force[1].position == 0.25 && isnan(c.force[1].omega));
    near_rel(c.time.output_every, 2 * PI / 5 / 50, 1e-15);
    fixed_point();
    bad(BASE "[force]\nvalue = 1 2 3\n", "test: [force] position: is missing");
    bad(BASE "[force]\nposition = 1\nvalue = 1 2 3\n",
        "test:8: position: must lie between the supports, or be all");
    bad(BASE "[force]\nposition = 0\nvalue = 1 2 3\n",
        "test:8: position: 0 is outside of 1e-09 to 1");
    bad(BASE "[force]\nposition = all\n", "test: [force] value: give either value or file");
    bad(BASE "[force]\nposition = all\nvalue = 1 2 3\nfile = a\n",
        "test:9: value: give either value or file");
    bad(BASE "[force]\nposition = all\nfile = a\nomega = 3\n",
        "test:10: omega: belongs to value, not to file");
    bad(BASE "[force]\nposition = all\nvalue = 1 2 3\nphase = 3\n", "test:10: phase: needs omega");
    good(BASE "[wind]\nspeed = 0 0 20\ndrag_coefficient = 1.2\ndiameter = 0.1\n", NULL);
    assert_true(c.wind.density == 1.225 && c.wind.cd == 1.2);
    fixed_point();
    bad(BASE "[wind]\nspeed = 0 0 20\ndiameter = 0.1\n",
        "test: [wind] drag_coefficient: is missing");
    bad(BASE "[wind]\nair_density = 1\n", "test: [wind] speed: is missing");
    good(BASE, NULL);
    assert_false(c.wind.cd > 0);
}

/* [stability]: defaults by method, refusals. */
static void stability(void **state)
{
    const struct stability *p = &c.stability;
    (void)state;

    good(BASE, "stability.method=floquet", "stability.modes=3 1");
    assert_true(p->amplitude_end == 0.1 && p->n_modes == 2 && p->mode[0] == 2 && p->mode[1] == 0);
    fixed_point();
    good(BASE, "stability.amplitude_end=0.3", "stability.quadratic=yes",
         "stability.ground=undamped", "stability.theory=classical");
    assert_true(p->amplitude_end == 0.3 && p->quadratic && p->undamped &&
                p->theory == THEORY_CLASSICAL);
    fixed_point();
    bad(BASE "[stability]\nmodes = 1 1.5\n",
        "test:8: modes: each must be a mode that the mesh has, from 1");
    bad(BASE "[stability]\nmodes = 121\n",
        "test:8: modes: each must be a mode that the mesh has, from 1");
    bad(BASE "[stability]\nmodes = 2 3 2\n", "test:8: modes: a mode is given twice");
    bad(BASE "[stability]\nreference_mode = 121\n",
        "test:8: reference_mode: the mesh has fewer modes");
    bad(BASE "[stability]\nratio_start = 2\nratio_end = 1\n",
        "test:9: ratio_end: must not lie below ratio_start");
    bad(BASE "[stability]\namplitude_start = 2\n",
        "test: [stability] amplitude_end: must not lie below amplitude_start");
}

static void time_refusals(void **state)
{
    static const char *const start[] = {"mode",     "mode 1",     "mode 0 1", "mode 121 1",
                                        "mode 1 x", "mode 1 1 1", "mode x 1", "mode 1 nan"};
    char text[512];
    (void)state;

    bad(BASE "[time]\nend = 0\n", "test:8: end: must be positive");
    for (size_t i = 0; i < sizeof start / sizeof *start; i++) {
        snprintf(text, sizeof text, "%s[time]\nstart = %s\n", BASE, start[i]);
        bad(text, "test:8: start: expected mode K AMPLITUDE with a mode that the mesh has");
    }
    good(BASE "[time]\nstart = of yesterday.state\n", NULL);
    assert_int_equal(c.time.start, START_STATE);
    assert_string_equal(c.time.start_text, "of yesterday.state");
    fixed_point();
    bad(BASE "[time]\nstart = rest\n[motion]\namplitude = 1 0 0\nomega = 1\n",
        "test:8: start: rest needs a ramp in each [motion]");
    bad(BASE "[nonlinear]\nterms = 4\n",
        "test:8: terms: '4': the number is too large (expected 0 to 3)");
    bad(BASE "[time]\nprobes = 0.5 1.01\n", "test:8: probes: 1.01 is outside of 0 to 1");
}

static void files(void **state)
{
    (void)state;
    assert_int_equal(case_load("none.ini", NULL, &c, &why), SW_READ);
    assert_string_equal(why.text, "none.ini: cannot be opened: No such file or directory");
    assert_int_equal(case_load("/", NULL, &c, &why), SW_READ);
    assert_string_equal(why.text, "/: is a directory; a file is expected");
    assert_int_equal(case_load("/dev/null", NULL, &c, &why), SW_FORMAT);
}

static void memory(void **state)
{
    static const char *const set[4] = {"mesh.elements=3", "damping.alpha=1", "time.end=2"};
    enum status s = SW_NOMEM;
    unsigned long n;
    (void)state;

    for (n = 1; s != SW_OK; n++) {
        mem_fail_at(n);
        s = read_with(BASE "[motion]\namplitude = 1 0 0\nomega = 1\n", set, &c);
        mem_fail_at(0);
        if (s != SW_OK) {
            assert_int_equal(s, SW_NOMEM);
            assert_string_equal(why.text, "memory ran out");
        }
    }
    assert_true(n > 20);
}

TEST_MAIN(cmocka_unit_test(defaults), cmocka_unit_test(output_interval),
          cmocka_unit_test(stiffness_both_ways), cmocka_unit_test(two_point_fit),
          cmocka_unit_test(one_sided_fit), cmocka_unit_test(motions), cmocka_unit_test(long_labels),
          cmocka_unit_test(any_number_of_motions), cmocka_unit_test(disturbances),
          cmocka_unit_test(times), cmocka_unit_test(probes), cmocka_unit_test(sets),
          cmocka_unit_test(models), cmocka_unit_test(names), cmocka_unit_test(values),
          cmocka_unit_test(missing), cmocka_unit_test(givens), cmocka_unit_test(branches),
          cmocka_unit_test(frequencies), cmocka_unit_test(given_refusals),
          cmocka_unit_test(too_short), cmocka_unit_test(loads), cmocka_unit_test(dampers),
          cmocka_unit_test(model_keys), cmocka_unit_test(damping),
          cmocka_unit_test(motion_refusals), cmocka_unit_test(disturbance_refusals),
          cmocka_unit_test(forces), cmocka_unit_test(stability), cmocka_unit_test(time_refusals),
          cmocka_unit_test(files), cmocka_unit_test(memory))
