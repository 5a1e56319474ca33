/* Arrangements from tables: columns, types, pairs, refusals, verdicts and their reasons. */
#include "textfile.h"

#include "form/judge.h"
#include "num/mem.h"

static struct why why;
static struct lift_given given;
static struct lift lift;

struct file {
    struct in in;
    struct lift_table t;
};

static enum status begin_with(struct file *f, const char *text, const char *set)
{
    struct opt_list sets = {&set, set != NULL};
    enum status s;

    f->in = in_with(text, strlen(text));
    strcpy(why.text, "nothing");
    err_level(1, 0);
    s = lift_begin(&f->in, &sets, &f->t, &why);
    if (s != SW_OK)
        in_close(&f->in);
    return s;
}

static void begin(struct file *f, const char *text, const char *set)
{
    if (begin_with(f, text, set) != SW_OK)
        print_error("%s\n", why.text);
    assert_string_equal(why.text, "nothing");
}

static enum status next(struct file *f)
{
    int end;
    enum status s = lift_row(&f->t, &given, &end, &why);

    assert_true(s != SW_OK || !end);
    return s == SW_OK ? lift_make(&given, &lift, &why) : s;
}

static void row(struct file *f)
{
    if (next(f) != SW_OK)
        print_error("%s\n", why.text);
    assert_string_equal(why.text, "nothing");
}

static void refused(struct file *f, const char *message)
{
    assert_true(next(f) != SW_OK);
    assert_string_equal(why.text, message);
    strcpy(why.text, "nothing");
}

static void no_more(struct file *f)
{
    int end;

    assert_int_equal(lift_row(&f->t, &given, &end, &why), SW_OK);
    assert_true(end);
    lift_end(&f->t);
    in_close(&f->in);
}

/* Every name is its own column; the suffix may stand behind the unit, too. */
static void names(void **state)
{
    static const struct {
        const char *name;
        int index, tolerance;
    } cases[] = {
        {"v_m", LIFT_AT(LIFT_V, 0), 0},
        {"v_1_m", LIFT_AT(LIFT_V, 1), 0},
        {"v_m_2", LIFT_AT(LIFT_V, 2), 0},
        {"v_m_tol", LIFT_AT(LIFT_V, 0), 1},
        {"phi_2_deg_tol", LIFT_AT(LIFT_PHI, 2), 1},
        {"m_load_1_t", LIFT_AT(LIFT_LOAD, 1), 0},
        {"m_spreader_t_1", LIFT_AT(LIFT_SPREADER, 1), 0},
        {"use_1", LIFT_AT(LIFT_USE, 1), 0},
        {"strain_wll", LIFT_AT(LIFT_STRAIN, 0), 0},
        {"wll_secondary_2_kN", LIFT_AT(LIFT_WLL_SECONDARY, 2), 0},
        {"wll_1_kN", LIFT_AT(LIFT_WLL, 1), 0},
        {"e1_m", LIFT_E1, 0},
        {"offset_m", LIFT_OFFSET, 0},
        {"e2_m_tol", LIFT_E2, 1},
        {"v", -1, 0},
        {"v_3_m", -1, 0},
        {"v_m_", -1, 0},
        {"_tol", -1, 0},
        {"tol", -1, 0},
        {"stabilized_tol", -1, 1},
        {"", -1, 0},
        {"sling_mm", -1, 0},
    };
    int tolerance;
    (void)state;

    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        if (lift_column(cases[i].name, &tolerance) != cases[i].index)
            print_error("%s\n", cases[i].name);
        assert_int_equal(lift_column(cases[i].name, &tolerance), cases[i].index);
        assert_true(cases[i].index < 0 || tolerance == cases[i].tolerance);
    }
    for (int i = 0; i < LIFT_NUMBERS; i++) {
        char name[LIFT_NAME];

        lift_name(i, name);
        assert_int_equal(lift_column(name, &tolerance), i);
        assert_int_equal(tolerance, 0);
    }
}

static void nearly(void **state)
{
    static const char *const cases[][2] = {
        {"phi", "phi_deg"},
        {"Phi_deg", "phi_deg"},
        {"phi_rad", "phi_deg"},
        {"gama_deg", "gamma_deg"},
        {"V", "v_m"},
        {"v_mm", "v_m"},
        {"m_load_kg", "m_load_t"},
        {"base_lng_m", "base_long_m"},
        {"Type", "type"},
        {"strain_wl", "strain_wll"},
        {"name", NULL},
        {"crane", NULL},
        {"remark", NULL},
        {"x_m", NULL},
        {"length_m", NULL},
        {"load", NULL},
        {"wll", "wll_kN"},
        {"z 1 m", "z_1_m"},
    };
    char close[LIFT_NAME];
    (void)state;

    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *found = lift_nearly(cases[i][0], close);

        if ((found == NULL) != (cases[i][1] == NULL) || (found && strcmp(found, cases[i][1])))
            print_error("%s: %s\n", cases[i][0], found ? found : "none");
        assert_int_equal(found == NULL, cases[i][1] == NULL);
        if (found)
            assert_string_equal(found, cases[i][1]);
    }
}

static void rows(void **state)
{
    struct file f;
    (void)state;

    begin(&f,
          "name,type,v_m,z_m,phi_deg,m_load_t,wll_kN,stabilized,z_m_tol,offset_m\n"
          "a,primary,6,2,30,50,200,,0.1,-0.2\n"
          "b,primary,6,2,3,,,yes,,\n",
          NULL);
    row(&f);
    assert_true(lift.ends == 1 && lift.end[0].type == RIGGING_PRIMARY && lift.end[0].v == 6);
    near_rel(lift.end[0].m_load, 5e4, 0);
    near_rel(lift.end[0].wll, 2e5, 0);
    near_rel(lift.end[0].T[0], tan(PI / 6), 1e-15);
    near_rel(lift.offset, 0.2, 0);
    near_rel(given.tol[LIFT_AT(LIFT_Z, 0)], 0.1, 0);
    assert_int_equal(lift.end[0].stabilized, 0);
    row(&f);
    assert_true(lift.end[0].stabilized && isnan(lift.offset) && isnan(lift.end[0].m_load));
    assert_true(given.tol[LIFT_AT(LIFT_Z, 0)] == 0);
    no_more(&f);
    begin(&f, "type,v_m,z_m\nprimary,6,2\n", "z_m=-1"); /* overrides */
    row(&f);
    near_rel(lift.end[0].z, -1, 0);
    no_more(&f);
    begin(&f, "type,v_m\nprimary,6\n", "z_m=-2"); /* adds */
    row(&f);
    near_rel(lift.end[0].z, -2, 0);
    no_more(&f);
}

static void headers(void **state)
{
    static const struct {
        const char *text, *message;
    } bad[] = {
        {"", "test: is empty; a header line is expected"},
        {"type;v_m\n", "test:1: columns are separated by ';'; expected ',' (and '.' in numbers)"},
        {"name,colour\n", "test:1: no column is one of sling; a header line is expected, such as "
                          "type,v_m,z_m,..."},
        {"type,v_m,v_m\n", "test:1: columns 2 and 3 are both 'v_m'"},
        {"type,v_1_m,v_m_1\n", "test:1: columns 2 and 3 are both 'v_m_1'"},
        {"type,name,name\n", "test:1: columns 2 and 3 are both 'name'"},
        {"type,h_m\n", "test:1: column 2: 'h_m' is a result of sling; leave it out"},
        {"type,gama_deg\n",
         "test:1: column 2: 'gama_deg' is no column of sling; is gamma_deg meant?"},
        {"typ\n", "test:1: column 1: 'typ' is no column of sling; is type meant?"},
    };
    static const char *const sets[] = {"v_m", "colour=3", "v=3", "=3", ""};
    struct file f;
    (void)state;

    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_int_equal(begin_with(&f, bad[i].text, NULL), SW_FORMAT);
        assert_string_equal(why.text, bad[i].message);
    }
    for (size_t i = 0; i < sizeof sets / sizeof *sets; i++)
        assert_int_equal(begin_with(&f, "type\n", sets[i]), SW_USAGE);
}

/* A row that cannot be used is named; the next one is as good as ever. */
static void bad_rows(void **state)
{
    struct file f;
    (void)state;

    begin(&f,
          "type,v_m,s_m,z_m,phi_deg,gamma_deg,m_spreader_t,m_load_t,z_m_tol,v_1_m\n"
          "primary,x,,2,30,,,,,\n"
          "primary,6,,2,30\n"
          ",6,,2,30,,,,,\n"
          "primery,6,,2,30,,,,,\n"
          "primary,6,,,30,,,,,\n"
          "primary,6,,2,30,,,,-1,\n"
          "primary,6,5,2,30,,,,,\n"
          "primary,6,,2,30,,,,,3\n"
          "primary-secondary,3,5,1,40,-45,2,60,,\n"
          "primary-secondary,3,5,1,90,-5,2,60,,\n"
          "primary-secondary,3,5,1,40,-5,-2,60,,\n"
          "primary-secondary,3,5,1,40,-5,2,60,,\n",
          NULL);
    refused(&f, "test:2: column 2: v_m: 'x': not a number");
    refused(&f, "test:3: 5 cells; the header has 10");
    refused(&f, "type: is missing");
    refused(&f, "test:5: column 1: type: 'primery': expected single, primary, primary-elastic, "
                "primary-secondary or pair");
    refused(&f, "z_m: is missing");
    refused(&f, "test:7: column 9: z_m_tol: '-1': a tolerance must not be negative");
    refused(&f, "s_m: type primary has no such quantity; is primary-secondary meant?");
    refused(&f, "v_1_m: belongs to an end of a pair; the type is not pair");
    refused(&f,
            "gamma_deg: leaves no base: v tan(phi) + s tan(gamma) must be positive (-2.4827 m)");
    refused(&f, "phi_deg: must lie above 0 and below 90 degrees (90 deg)");
    refused(&f, "m_spreader_t: must not be negative (-2 t)");
    row(&f);
    no_more(&f);
}

#define PAIR                                                                                       \
    "type,e1_m,e2_m,m_load_t,m_load_1_t,m_load_2_t,z_1_m,v_2_m,s_2_m,z_2_m,phi_2_deg,"             \
    "gamma_2_deg,m_spreader_2_t,type_1,type_2,m_spreader_t\n"

static void pairs(void **state)
{
    struct file f;
    struct judgement j;
    (void)state;

    begin(&f,
          PAIR "pair,,,,15,15,0.8,2,3.5,-1,45,-8,1,,,\n"
               "pair,3,3,30,,,0.8,2,3.5,-1,45,-8,1,single,primary-secondary,\n"
               "pair,1,2,30,,,0.8,2,,-1,45,,,,,\n"
               "pair,,,30,10,,0.8,2,,-1,45,,,,,\n"
               "pair,,,,,,0.8,2,,-1,45,,,,,\n"
               "pair,1,2,,15,15,0.8,2,,-1,45,,,,,\n"
               "pair,,,40,15,15,0.8,2,,-1,45,,,,,\n"
               "pair,-1,2,,,,0.8,2,,-1,45,,,,,\n"
               "pair,1,2,,,,0.8,2,,-1,45,,,pair,,\n"
               "pair,1,2,,,,0.8,2,3.5,-1,45,-8,1,,,\n"
               "pair,1,2,,,,0.8,2,3.5,-1,45,-8,1,,,5\n",
          NULL);
    for (int i = 0; i < 2; i++) { /* 1.2.8 */
        row(&f);
        assert_true(lift.ends == 2 && lift.end[0].type == RIGGING_SINGLE);
        assert_int_equal(lift.end[1].type, RIGGING_SECONDARY);
        near_rel(lift.share[0], 0.5, 1e-15);
        judge(&lift, 0, NAN, &j);
        near_abs(j.h, 1.1, 0.05);
        near_abs(j.end[0].h, -0.8, 1e-15);
        near_abs(j.end[1].h, 3.05, 0.5e-2);
        near_abs(j.coupled, 0.71654, 1e-5);
        near_rel(j.rise, j.coupled, 1e-15);
        near_abs(j.centre - j.virtual_centre, j.h, 1e-14);
        assert_int_equal(j.verdict, VERDICT_STABLE);
    }
    row(&f); /* m1 : m2 = e2 : e1; the end without secondary slings is primary */
    near_rel(lift.share[0], 2.0 / 3, 1e-15);
    near_rel(lift.end[1].m_load, 1e4, 1e-15);
    assert_int_equal(lift.end[1].type, RIGGING_PRIMARY);
    row(&f);
    near_rel(lift.share[0], 1.0 / 3, 1e-15);
    refused(&f, "e1_m: is missing; a pair needs e1_m and e2_m, or m_load_1_t and m_load_2_t");
    refused(&f, "e1_m: contradicts the masses: m_1 to m_2 must be as e2 to e1");
    refused(&f, "m_load_t: is not the sum of the masses of the ends");
    refused(&f, "e1_m: must be positive");
    refused(&f, "type_1: an end of a pair is no pair");
    refused(&f, "m_load_2_t: is missing");
    refused(&f, "m_spreader_t: a pair has m_spreader_1_t and m_spreader_2_t, each with its end");
    no_more(&f);
}

/* (36) calls this stable; but the stiff load's front end capsizes first. */
static void unstable_end(void **state)
{
    struct file f;
    struct judgement j;
    (void)state;

    begin(&f, PAIR "pair,,,,15,15,2.5,2,3.5,-1,45,-8,1,,,\n", NULL);
    row(&f);
    judge(&lift, 0, NAN, &j);
    assert_true(j.h > 0.2 && j.coupled < 0 && j.rise < 0);
    assert_int_equal(j.verdict, VERDICT_UNSTABLE);
    no_more(&f);
}

/* Both ends as the whole; ends exchanged. */
static void symmetry(void **state)
{
    struct file f;
    struct judgement one, two, back;
    (void)state;

    begin(&f,
          "type,v_m,s_m,z_m,phi_deg,gamma_deg,m_spreader_t,m_load_t,m_spreader_1_t,m_spreader_2_t,"
          "e1_m,e2_m,s_1_m,s_2_m,offset_m\n"
          "primary-secondary,3.6,7.5,1.1,26,-4,2,60,,,,,,,.1\n"
          "pair,3.6,7.5,1.1,26,-4,,60,1,1,3,3,,,.1\n"
          "pair,3.6,,1.1,26,-4,,60,1,2,3,4,5,6,.1\n"
          "pair,3.6,,1.1,26,-4,,60,2,1,4,3,6,5,.1\n",
          NULL);
    row(&f);
    judge(&lift, 0, NAN, &one);
    row(&f);
    judge(&lift, 0, NAN, &two);
    near_rel(two.h, one.h, 1e-14);
    near_rel(two.coupled, one.rise, 1e-13); /* over the tilt of the load */
    near_rel(two.rise, one.rise, 1e-13);
    near_rel(two.at.primary_low, one.at.primary_low, 1e-13);
    near_rel(two.at.secondary_high, one.at.secondary_high, 1e-13);
    near_rel(two.at.load, one.at.load, 1e-13);
    row(&f);
    judge(&lift, 0, NAN, &two);
    row(&f);
    judge(&lift, 0, NAN, &back);
    near_rel(back.h, two.h, 1e-14);
    near_rel(back.coupled, two.coupled, 1e-14);
    near_rel(back.rise, two.rise, 1e-13);
    near_rel(back.end[0].at.primary_low, two.end[1].at.primary_low, 1e-13);
    near_rel(back.virtual_centre, two.virtual_centre, 1e-13);
    no_more(&f);
}

/* What is resolved makes the same again. */
static void resolved(void **state)
{
    struct file f;
    (void)state;

    begin(&f,
          "type,v_m,s_m,z_m,phi_deg,gamma_deg,m_spreader_t,m_load_t,sling_m,base_long_m,"
          "base_cross_m,strain_wll,wll_kN,m_spreader_1_t,m_spreader_2_t,e1_m,e2_m\n"
          "primary-secondary,,7.5,1.1,26,,2,60,4,,3,,,,,,\n"
          "primary,,,2,,,,,9,6,4,,,,,,\n"
          "primary-elastic,14,,8,,,,90,,7.7,5.9,0.02,400,,,,\n"
          "pair,3.6,7.5,1.1,26,-4,,60,,,,,,1,2,3,4\n",
          NULL);
    for (int i = 0; i < 4; i++) {
        struct lift again;
        struct lift_given all;

        row(&f);
        all = given;
        lift_resolve(&lift, &all);
        assert_int_equal(lift_make(&all, &again, &why), SW_OK);
        near_rel(judge_height(&again), judge_height(&lift), 1e-12);
    }
    no_more(&f);
}

static void verdict(const char *cells, double limit, double worst, enum verdict wanted,
                    const char *reason)
{
    char text[500];
    struct file f;
    struct judgement j;

    snprintf(text, sizeof text,
             "type,v_m,s_m,z_m,phi_deg,gamma_deg,m_spreader_t,m_load_t,wll_kN,offset_m,base_long_m,"
             "base_cross_m,strain_wll,use\n%s\n",
             cells);
    begin(&f, text, NULL);
    row(&f);
    judge(&lift, limit, worst, &j);
    if (j.verdict != wanted || !strstr(j.why, reason))
        print_error("%s: %s, %s\n", cells, verdict_name(j.verdict), j.why);
    assert_int_equal(j.verdict, wanted);
    assert_non_null(strstr(j.why, reason));
    no_more(&f);
}

/* Each verdict with its rule and number; the worst view decides. */
static void verdicts(void **state)
{
    (void)state;
    verdict("single,,,-1,,,,,,,,,,", 0, NAN, VERDICT_STABLE, "h = 1 m is above 0: h = -z");
    verdict("single,,,0,,,,,,,,,,", 0, NAN, VERDICT_UNSTABLE, "h = 0 m is not above 0");
    verdict("single,,,1,,,,,,,,,,", 0, NAN, VERDICT_UNSTABLE, "h = -1 m");
    verdict("primary,6,,2,30,,,,,,,,,", 0, NAN, VERDICT_STABLE, "h_long = 4 m");
    verdict("primary,6,,2,30,,,,,,,,,", 4, NAN, VERDICT_STABLE, "not below the limit 4 m");
    verdict("primary,6,,2,30,,,,,,,,,", 4.5, NAN, VERDICT_MARGINAL, "4 m is below the limit 4.5 m");
    verdict("primary,6,,2,30,,,,,,,,,", 0, -0.5, VERDICT_MARGINAL, "-0.5 m within the tolerances");
    verdict("primary,6,,2,30,,,,,,,,,", 1, 0.5, VERDICT_MARGINAL, "0.5 m within the tolerances");
    verdict("primary,6,,2,30,,,,,,,,,", 1, -INFINITY, VERDICT_MARGINAL,
            "the tolerances reach what is no");
    verdict("primary,6,,2,30,,,,,,,,,", 0, 0.5, VERDICT_STABLE, "h_long = 4 m");
    verdict("primary,6,,2,30,,,,,,,,,", 0, 0, VERDICT_MARGINAL, "but 0 m within the tolerances");
    verdict("primary,6,,2,,,,,,,6,0.5,,", 0, NAN, VERDICT_UNSTABLE, "h_cross = -2 m");
    verdict("primary,6,,2,4,,,,,,,,,", 0, NAN, VERDICT_UNSTABLE, "phi < 5 deg and z > v tan(phi)");
    verdict("primary,6,,2,,,,,,,,,,", 0, NAN, VERDICT_NONE, "phi is missing");
    verdict("primary,6,,7,,,,,,,,,,", 0, NAN, VERDICT_UNSTABLE, "h_long = -1 m");
    verdict("primary,6,,-2,,,,,,,,,,", 0, NAN, VERDICT_STABLE, "h_long = 8 m");
    verdict("primary,6,,2,30,,,60,169,,,,,", 0, NAN, VERDICT_NONE, "1.005 of its working load");
    verdict("primary,6,,2,30,,,60,171,,,,,", 0, NAN, VERDICT_STABLE, "h_long = 4 m");
    verdict("primary,6,,2,30,,,60,,2.5,,,,", 0, NAN, VERDICT_NONE, "makes a sling slack");
    verdict("primary,6,,2,30,,,60,,2,,,,", 0, NAN, VERDICT_STABLE, "h_long = 4 m");
    verdict("primary-elastic,14.5,,8.4,,,,,,,7.7,5.9,0.023,", 0, NAN, VERDICT_STABLE,
            "h_long = 2.282 m is above 0: elastic slings lengthwise; (25) corrected");
    verdict("primary-elastic,14.5,,8.4,,,,,,,12,2,0.023,", 0, NAN, VERDICT_UNSTABLE,
            "elastic slings crosswise; (32) corrected");
    verdict("primary-elastic,14.5,,8.4,,,,,,,7.7,5.9,0.023,1.2", 0, NAN, VERDICT_NONE,
            "1.2 of its working load");
    verdict("primary-secondary,3.6,7.5,1.1,26,-6,2,60,,,,,,", 0, NAN, VERDICT_UNSTABLE,
            "h_cross = -0.03367 m");
    verdict("primary-secondary,3.6,7.5,1.1,4,1,2,60,,,,,,", 0, NAN, VERDICT_NONE,
            "under a spreader: no rule is known");
    verdict("primary-secondary,3.6,7.5,0.1,4,1,2,60,,,,,,", 0, NAN, VERDICT_STABLE, "h_cross = ");
}

/* Far below its lifting points the load pulls the other side of the secondary slings more: the use
 * is that of the greater force. */
static void greatest_force(void **state)
{
    struct file f;
    struct judgement j;
    (void)state;

    begin(&f,
          "type,v_m,s_m,z_m,phi_deg,gamma_deg,m_spreader_t,m_load_t,wll_kN,offset_m\n"
          "primary-secondary,1,10,-2,75,-18,0,60,900,2\n",
          NULL);
    row(&f);
    judge(&lift, 0, NAN, &j);
    near_rel(j.use_secondary * 9e5, fmax(j.at.secondary_low, j.at.secondary_high), 1e-14);
    assert_true(j.at.secondary_high > j.at.secondary_low);
    no_more(&f);
}

static void no_memory(void **state)
{
    const char *const set[] = {"z_m=1", "v_m=2"};
    struct opt_list sets = {(const char **)set, 2};
    unsigned long n = 0;
    enum status s;
    (void)state;

    do {
        const char *text = "type\nprimary\n";
        struct in in = in_with(text, strlen(text));
        struct lift_table t;
        int end = 0;

        mem_fail_at(++n);
        s = lift_begin(&in, &sets, &t, &why);
        if (s == SW_OK) {
            while (!end && s == SW_OK)
                s = lift_row(&t, &given, &end, &why);
            lift_end(&t);
        }
        mem_fail_at(0);
        assert_true(s == SW_OK || s == SW_NOMEM);
        in_close(&in);
    } while (s != SW_OK && n < 100);
    assert_true(n > 5 && n < 100);
}

TEST_MAIN(cmocka_unit_test(names), cmocka_unit_test(nearly), cmocka_unit_test(rows),
          cmocka_unit_test(headers), cmocka_unit_test(bad_rows), cmocka_unit_test(pairs),
          cmocka_unit_test(unstable_end), cmocka_unit_test(symmetry), cmocka_unit_test(resolved),
          cmocka_unit_test(verdicts), cmocka_unit_test(greatest_force), cmocka_unit_test(no_memory))
