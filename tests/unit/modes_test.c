/* Eigenmodes: the thesis' tables, values of theory section 2, closed forms, orthogonality. */
#include "check.h"
#include "num/mem.h"
#include "phys/modes.h"
#include "sys/csv.h"

#include <string.h>

static struct modes solve(const struct cable *c, enum law law, int n, int k, struct model *ret)
{
    struct modes p;

    assert_int_equal(model_new(c, law, n, ret), SW_OK);
    assert_int_equal(modes_lowest(ret, k, SOLVER_DENSE, &p), SW_OK);
    return p;
}

/* One unit of the sixth significant digit. */
static double unit_of_sixth_digit(double omega)
{
    return pow(10, floor(log10(omega)) - 5) * (1 + 1e-9);
}

/* The cable, mesh and mode that a quantity of published.csv is the frequency of; 0: of none. */
static int is_frequency(const char *quantity, const struct cable **cable, int *n, int *mode)
{
    int rope, end = 0;

    if (sscanf(quantity, "rope %d with %d elements: omega %d%n", &rope, n, mode, &end) == 3) {
        *cable = rope == 1 ? &seil1 : &seil2;
    } else if (sscanf(quantity, "omega %d%n", mode, &end) == 1) {
        *cable = &pont;
        *n = 10;
    }
    return end > 0 && quantity[end] == '\0';
}

/* The frequencies of a table of published numbers, law printed; returns how many there are. */
static int published_frequencies(const char *file)
{
    struct in in;
    struct why why;
    struct csv csv;
    struct modes p = {0};
    struct model m = {.n = 0};
    const struct cable *cable = NULL, *present = NULL;
    int rows = 0, n, mode;
    double worst = 0;

    assert_int_equal(in_open(file, &in, &why), SW_OK);
    assert_int_equal(csv_begin(&in, &csv, &why), SW_OK);
    assert_int_equal(csv_header(&csv, &why), SW_OK);
    for (;;) {
        double omega, error;

        assert_int_equal(csv_row(&csv, &why), SW_OK);
        if (csv.n == 0)
            break;
        if (!is_frequency(csv.cell[0], &cable, &n, &mode))
            continue;
        assert_int_equal(csv_number(&csv, 2, &omega, &why), SW_OK);
        if (m.n != n || present != cable) {
            modes_free(&p);
            if (m.n > 0)
                model_free(&m);
            p = solve(cable, LAW_PRINTED, n, 32, &m);
            present = cable;
        }
        error = fabs(p.omega[mode - 1] - omega) / unit_of_sixth_digit(omega);
        if (!(error <= 1))
            print_error("%s: %s: %.9g, published %g\n", file, csv.cell[0], p.omega[mode - 1],
                        omega);
        assert_true(error <= 1);
        worst = fmax(worst, error);
        rows++;
    }
    print_message("# %s: worst deviation: %.2f units of the sixth digit\n", file, worst);
    modes_free(&p);
    model_free(&m);
    csv_end(&csv);
    in_close(&in);
    return rows;
}

/* The 192 frequencies of Bild A.9, A.10 (those of sheets A.4 and A.5 are among them) and the 17 of
 * sheet A.3. */
static void published_tables(void **state)
{
    (void)state;
    assert_int_equal(published_frequencies("scripts/experiments/frequencies/published.csv"), 192);
    assert_int_equal(published_frequencies("scripts/experiments/ben-ahin/published.csv"), 17);
}

/* Theory section 2: omega 1 and 2 for n = 10, to the printed digits. */
static void laws_thesis_and_hooke(void **state)
{
    static const struct {
        const struct cable *cable;
        enum law law;
        double omega[2];
    } row[] = {{&pont, LAW_THESIS, {7.82866, 7.85212}},  {&pont, LAW_HOOKE, {7.82866, 7.85192}},
               {&seil1, LAW_THESIS, {4.84320, 5.10023}}, {&seil1, LAW_HOOKE, {4.84320, 5.09927}},
               {&seil2, LAW_THESIS, {4.55952, 4.90114}}, {&seil2, LAW_HOOKE, {4.55952, 4.90002}}};
    (void)state;

    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct model m;
        struct modes p = solve(row[i].cable, row[i].law, 10, 2, &m);

        near_abs(p.omega[0], row[i].omega[0], 5e-6);
        near_abs(p.omega[1], row[i].omega[1], 5e-6);
        assert_int_equal(p.plane[0], PART_LATERAL);
        assert_int_equal(p.plane[1], PART_PLANE);
        modes_free(&p);
        model_free(&m);
    }
}

/* Without gravity: strings under T = EA (a - 1)/a in both planes, a bar along the chord. */
static void string_and_bar(void **state)
{
    const struct cable c = {100, 2, 1e6, 0, 60.6, 80.8}; /* chord 101 */
    double a = 1.01, T = 1e6 * 0.01 / a;
    struct model m;
    struct modes p = solve(&c, LAW_HOOKE, 40, 240, &m);
    int bar = 0;
    (void)state;

    for (int i = 0; i < 10; i++) { /* pairs: in and out of the plane */
        double omega = (i / 2 + 1) * PI / c.L0 * sqrt(T / c.mu);

        near_rel(p.omega[i], omega, 1e-7);
        assert_int_not_equal(p.plane[2 * (i / 2)], p.plane[2 * (i / 2) + 1]);
    }
    for (int i = 0; i < 240; i++)
        bar += fabs(p.omega[i] / (PI / c.L0 * sqrt(c.EA / c.mu)) - 1) < 1e-8;
    assert_int_equal(bar, 1);
    modes_free(&p);
    model_free(&m);
}

/* Irvine's symmetric in-plane root, with the mass per metre of chord: small sag, no axial inertia,
 * hence 1e-3.  Level cables, and one at 60 degrees whose
 * tension is ten times its weight. */
static void irvine(void **state)
{
    const struct cable steep = {99.8, 1, 5e6, 9.81, 50, 86.60254037844386};
    const struct cable *const cable[] = {&pont, &seil1, &seil2, &steep};
    (void)state;

    for (int i = 0; i < 4; i++) {
        const struct cable *c = cable[i];
        struct model m;
        struct modes p = solve(c, LAW_HOOKE, 20, 2, &m);
        double chord = line_chord(c), mass = c->mu * c->L0 / chord, low = PI, high = 3 * PI;
        double lambda2 = line_lambda2(&m.line, mass), tension = m.line.H * chord / c->span;

        while (high - low > 1e-12) {
            double x = (low + high) / 4; /* half of xb */

            if (sin(x) - (x - 4 / lambda2 * x * x * x) * cos(x) < 0)
                high = 2 * x;
            else
                low = 2 * x;
        }
        near_rel(p.omega[0], PI / chord * sqrt(tension / mass), 1e-3);
        near_rel(p.omega[1], low / chord * sqrt(tension / mass), 1e-3);
        modes_free(&p);
        model_free(&m);
    }
}

/* phi^T A psi with the free part of a matrix. */
static double product(const struct band *A, const double *x, const double *y, double *work)
{
    double sum = 0;

    for (int i = 0; i < A->n; i++)
        work[i] = 0;
    band_multiply_add(A, 1, y, work);
    for (int i = 0; i < A->n; i++)
        sum += x[i] * work[i];
    return sum;
}

static void check_orthogonality(const struct cable *c, int n)
{
    struct model m;
    struct modes p = solve(c, LAW_HOOKE, n, 6 * n, &m);
    struct band M, K;
    struct partition Mp, Kp;
    double *work = mem_doubles(6 * (size_t)n), worst[3] = {0, 0, 0}, top;

    assert_int_equal(model_mass(&m, PART_ALL, &M), SW_OK);
    assert_int_equal(model_stiffness(&m, PART_ALL, &K), SW_OK);
    assert_int_equal(model_partition(&m, &M, &Mp), SW_OK);
    assert_int_equal(model_partition(&m, &K, &Kp), SW_OK);
    top = p.omega[p.k - 1] * p.omega[p.k - 1];
    for (int i = 0; i < p.k; i++)
        for (int j = 0; j <= i; j++) {
            const double *x = p.phi + (size_t)p.n * (size_t)i, *y = p.phi + (size_t)p.n * (size_t)j;
            double square = i == j ? p.omega[i] * p.omega[i] : 0;
            double k = product(&Kp.free, x, y, work) - square;

            worst[0] = fmax(worst[0], fabs(product(&Mp.free, x, y, work) - (i == j)));
            worst[1] = fmax(worst[1], fabs(k) / top);
            if (i < 20 && i != j)
                worst[2] = fmax(worst[2], fabs(k) / (p.omega[i] * p.omega[j]));
        }
    print_message("# n %d: mass %.2g, stiffness %.2g, low modes %.2g\n", n, worst[0], worst[1],
                  worst[2]);
    below(worst[0], 1e-10);
    below(worst[1], 1e-10);
    below(worst[2], 1e-6);
    free(work);
    partition_free(&Mp);
    partition_free(&Kp);
    band_free(&M);
    band_free(&K);
    modes_free(&p);
    model_free(&m);
}

static void orthogonality(void **state)
{
    const struct cable slack = {300, 2, 1e7, 9.81, 100, 35};
    (void)state;

    check_orthogonality(&pont, 10);
    check_orthogonality(&seil1, 60);
    check_orthogonality(&slack, 30);
}

/* Signs, unit shapes, zero entries of the other plane, and symmetry under turning end for end. */
static void shapes(void **state)
{
    struct cable c = {112, 2, 1e6, 9.81, 100, 30}, turned = c;
    struct model m, t;
    struct modes p = solve(&c, LAW_HOOKE, 12, 72, &m), q;
    double V[6 * 13], most;
    (void)state;

    turned.drop = -c.drop;
    q = solve(&turned, LAW_HOOKE, 12, 72, &t);
    for (int i = 0; i < 72; i++)
        near_rel(q.omega[i], p.omega[i], 1e-9);
    for (int i = 0; i < 20; i++) {
        double largest = 0;

        modes_unit_shape(&m, &p, i, V);
        most = 0;
        for (int k = 0; k <= 12; k++) {
            double *v = V + 6 * k;

            most = fmax(most, sqrt(v[0] * v[0] + v[2] * v[2] + v[4] * v[4]));
            for (int a = 0; a < 6; a += 2)
                largest = fabs(v[a]) > fabs(largest) * (1 + 1e-6) ? v[a] : largest;
            assert_true(p.plane[i] == PART_PLANE ? v[4] == 0 && v[5] == 0 : v[0] == 0 && v[2] == 0);
        }
        near_abs(most, 1, 1e-12);
        assert_true(largest > 0);
        for (int a = 0; a < 6; a += 2)
            assert_true(V[a] == 0 && V[72 + a] == 0);
    }
    modes_free(&p);
    modes_free(&q);
    model_free(&m);
    model_free(&t);
}

/* Rigid translations of all nodes strain nothing and carry the whole mass: the three parts of the
 * matrices fit together. */
static void partitions(void **state)
{
    const struct cable c = {112, 2, 1e6, 9.81, 100, 30};
    struct model m;
    struct band M, K;
    struct partition Mp, Kp;
    (void)state;

    assert_int_equal(model_new(&c, LAW_HOOKE, 4, &m), SW_OK);
    assert_int_equal(model_mass(&m, PART_ALL, &M), SW_OK);
    assert_int_equal(model_stiffness(&m, PART_ALL, &K), SW_OK);
    assert_int_equal(model_partition(&m, &M, &Mp), SW_OK);
    assert_int_equal(model_partition(&m, &K, &Kp), SW_OK);
    for (int axis = 0; axis < 3; axis++) {
        double one[24], force[24] = {0}, inertia[24] = {0}, mass = 0;

        for (int i = 0; i < 24; i++) /* free 0..2: slopes of node 0; then node 1 ... */
            one[i] = i >= 3 && i < 21 && (i - 3) % 6 == 2 * axis;
        band_multiply_add(&Kp.free, 1, one, force);
        band_multiply_add(&Mp.free, 1, one, inertia);
        for (int i = 0; i < 24; i++) {
            double rest = Kp.support[i + 24 * axis] + Kp.support[i + 24 * (axis + 3)];

            near_abs(force[i] + rest, 0, 1e-6);
            mass += one[i] * (inertia[i] +
                              2 * (Mp.support[i + 24 * axis] + Mp.support[i + 24 * (axis + 3)]));
        }
        mass += Mp.reaction[axis + 6 * axis] + 2 * Mp.reaction[axis + 6 * (axis + 3)] +
                Mp.reaction[axis + 3 + 6 * (axis + 3)];
        near_rel(mass, c.mu * c.L0, 1e-13);
    }
    partition_free(&Mp);
    partition_free(&Kp);
    band_free(&M);
    band_free(&K);
    model_free(&m);
}

/* theory c4: the bound is exact to 1e-5 for taut cables and up to a few per cent high else, so
 * that 0.9 of the critical step is stable.  Random cables, slack ones too. */
static void largest_frequency(void **state)
{
    uint64_t seed = 7;
    double low = INFINITY, high = 0;
    (void)state;

    for (int i = 0; i < 60; i++) {
        struct cable c = {0, 1, 0, 9.81, 100, uniform_in(&seed, -80, 80)};
        double chord = hypot(c.span, c.drop), ratio;
        int n = 5 + (int)(35 * uniform(&seed));
        struct model m;
        struct modes p;

        c.L0 = chord * (i < 20 ? 0.998 : log_uniform(&seed, 1, 3));
        c.EA = c.mu * c.g * c.L0 * log_uniform(&seed, 1e3, 1e7);
        p = solve(&c, LAW_HOOKE, n, 6 * n, &m);
        ratio = model_omega_max(&m) / p.omega[p.k - 1];
        low = fmin(low, ratio);
        high = fmax(high, ratio);
        modes_free(&p);
        model_free(&m);
    }
    print_message("# bound over largest frequency: %.6f to %.4f\n", low, high);
    below(1 - 1e-4, low);
    below(high, 1.06);
}

static void memory_runs_out(void **state)
{
    unsigned long n = 0;
    enum status s;
    (void)state;

    do {
        struct model m;
        struct modes p;

        mem_fail_at(++n);
        s = model_new(&seil1, LAW_HOOKE, 3, &m);
        if (s == SW_OK)
            s = modes_lowest(&m, 4, SOLVER_DENSE, &p);
        if (s == SW_OK)
            modes_free(&p);
        model_free(&m);
        assert_true(s == SW_OK || s == SW_NOMEM);
    } while (s != SW_OK);
    mem_fail_at(0);
    assert_true(n > 20);
}

TEST_MAIN(cmocka_unit_test(published_tables), cmocka_unit_test(laws_thesis_and_hooke),
          cmocka_unit_test(string_and_bar), cmocka_unit_test(irvine),
          cmocka_unit_test(orthogonality), cmocka_unit_test(shapes), cmocka_unit_test(partitions),
          cmocka_unit_test(largest_frequency), cmocka_unit_test(memory_runs_out))
