/*
 * One step of all lanes, WIDTH of them in a register: the body of STEP, included once for each
 * width (compilers do badly with vectors wider than a register).  No guard, for that reason.
 *
 * A number of all lanes takes S registers; P is which of them a function works on, so that entry i
 * of a vector over all nodes stands at [S * i] behind it.
 */
#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#define IN(name) JOIN(name##_, WIDTH) /* a name for this width */
#define S (LANES / WIDTH)
#define vec IN(vec)
#define mask IN(mask)
#define part IN(part)

typedef double vec __attribute__((vector_size(8 * WIDTH), may_alias));
typedef long mask __attribute__((vector_size(8 * WIDTH), may_alias));

/* The lanes of one register: what struct lanes has, from there on. */
struct part {
    const struct lanes *all;
    vec *V, *D, *Y;
    const vec *factor, *support;
    vec next[6]; /* displacements of the supports at the end of the step */
    vec scale, gamma, limit, bad, slack;
};

/* Y -= internal forces of element k; bad and slack as seen there. */
static INLINE_BODY void IN(element)(struct part *p, size_t k, int terms)
{
    const struct lanes *all = p->all;
    const double *m = all->material + k * GAUSS * N_FIELDS;
    const double t1 = terms >= 1, t2 = terms >= 2, t3 = terms >= 3;
    const vec *V = p->V + S * 6 * k;
    vec *Y = p->Y + S * 6 * k;
    vec d[3], a[3], b[3], fd[3] = {{0}}, fa[3] = {{0}}, fb[3] = {{0}};

    for (int c = 0; c < 3; c++) {
        d[c] = V[S * (6 + 2 * c)] - V[S * 2 * c];
        a[c] = V[S * (2 * c + 1)];
        b[c] = V[S * (2 * c + 7)];
    }
    for (int q = 0; q < GAUSS; q++, m += N_FIELDS) {
        const double *f = all->slope[q];
        vec w[3], along, half, T, X, room;

        for (int c = 0; c < 3; c++)
            w[c] = f[0] * d[c] + f[1] * a[c] + f[2] * b[c];
        along = m[FIELD_X1] * w[0] + m[FIELD_X2] * w[1];
        half = 0.5 * (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
        T = m[FIELD_T] + m[FIELD_EA] * (t1 * along + t3 * half);
        X = m[FIELD_EA] * (along + t2 * half);
        for (int c = 0; c < 3; c++) {
            vec n = T * w[c];

            if (c < 2)
                n += X * m[c == 0 ? FIELD_X1 : FIELD_X2];
            fd[c] += f[0] * n;
            fa[c] += f[1] * n;
            fb[c] += f[2] * n;
        }
        T = m[FIELD_T] + m[FIELD_EA] * (along + half);
        room = p->limit - m[FIELD_STIFF] * (along + half);
        p->bad = (vec)((mask)p->bad | (mask)room); /* their sign is what counts */
        p->slack = (vec)((mask)p->slack | (mask)T);
    }
    for (int c = 0; c < 3; c++) {
        Y[S * 2 * c] += fd[c];
        Y[S * (2 * c + 1)] -= fa[c];
        Y[S * (2 * c + 6)] = -fd[c];
        Y[S * (2 * c + 7)] = -fb[c];
    }
}

static INLINE_BODY void IN(forces)(struct part *p, int terms)
{
    p->bad = p->slack = (vec){0};
    for (int i = 0; i < 6; i++)
        p->Y[S * i] = (vec){0};
    for (size_t k = 0; k < (size_t)p->all->model->n; k++)
        IN(element)(p, k, terms);
}

/* Y += scale M D at node k, the component at c; at the ends the slope's row only. */
static INLINE_BODY void IN(mass)(struct part *p, size_t k, size_t c)
{
    const double *m = p->all->mass;
    const vec *D = p->D + S * (6 * k + c), *left = D - S * 6, *right = D + S * 6;
    vec *Y = p->Y + S * (6 * k + c), scale = p->scale;

    if (k == 0) {
        Y[S] += scale * (m[5] * D[0] + m[6] * D[S] + m[2] * right[0] - m[4] * right[S]);
    } else if (k == (size_t)p->all->model->n) {
        Y[S] += scale * (m[6] * D[S] - m[5] * D[0] - m[2] * left[0] - m[4] * left[S]);
    } else {
        Y[0] += scale * (m[0] * D[0] + m[1] * (left[0] + right[0]) + m[2] * (left[S] - right[S]));
        Y[S] += scale * (m[3] * D[S] - m[4] * (left[S] + right[S]) + m[2] * (right[0] - left[0]));
    }
}

/* Y of the slopes at a support and of the next node, less columns of A times what is known. */
static INLINE_BODY void IN(hold_beta)(struct part *p, size_t side, const vec known[3])
{
    const vec *A = p->support + S * SUPPORT * side;
    size_t n = (size_t)p->all->model->n;
    vec *own = p->Y + S * 6 * n * side, *next = p->Y + S * (side ? 6 * n - 6 : 6);

    for (int i = 0; i < 2; i++, A += S * SUPPORT_PLANE) {
        own[S] -= A[0] * known[i];
        own[S * 3] -= A[S] * known[i];
        for (int j = 0; j < 4; j++)
            next[S * j] -= A[S * (2 + j)] * known[i];
    }
    own[S * 5] -= A[0] * known[2];
    next[S * 4] -= A[S] * known[2];
    next[S * 5] -= A[S * 2] * known[2];
}

static INLINE_BODY void IN(hold_mass)(struct part *p, size_t side, const vec known[3])
{
    const double *M = p->all->mass_support[side];
    size_t n = (size_t)p->all->model->n;
    vec *own = p->Y + S * 6 * n * side, *next = p->Y + S * (side ? 6 * n - 6 : 6);

    for (int c = 0; c < 3; c++) {
        own[S * (2 * c + 1)] -= M[0] * known[c];
        next[S * 2 * c] -= M[1] * known[c];
        next[S * (2 * c + 1)] -= M[2] * known[c];
    }
}

/* The same for both supports; then the rows of their displacements. */
static INLINE_BODY void IN(hold)(struct part *p, const vec known[6])
{
    size_t n = (size_t)p->all->model->n;

    for (size_t side = 0; side < 2; side++)
        if (p->all->beta)
            IN(hold_beta)(p, side, known + 3 * side);
        else
            IN(hold_mass)(p, side, known + 3 * side);
    for (size_t i = 0; i < 6; i++)
        p->Y[S * (6 * n * (i / 3) + 2 * (i % 3))] = known[i];
}

/*
 * Substitution for the unknowns x of one node, width of them.  L: block of this node, N: of the one
 * after it; their entries are stride apart (S registers, or 1 double that serves all lanes).
 */
#define FORWARD(L, stride, width, before, x)                                                       \
    for (int r = 0; r < (width); r++) {                                                            \
        for (int u = 0; u < (width); u++)                                                          \
            (x)[r] -= (L)[(stride) * ((width)*r + u)] * (before)[u];                               \
        for (int u = 0; u < r; u++)                                                                \
            (x)[r] -= (L)[(stride) * ((width) * (width) + within(r, u))] * (x)[u];                 \
    }
#define BACKWARD(L, N, stride, width, after, x)                                                    \
    for (int r = (width)-1; r >= 0; r--) {                                                         \
        (x)[r] *= (L)[(stride) * ((width) * (width) + within(width, r))];                          \
        for (int u = 0; u < (width); u++)                                                          \
            (x)[r] -= (N)[(stride) * ((width)*u + r)] * (after)[u];                                \
        for (int u = (width)-1; u > r; u--)                                                        \
            (x)[r] -= (L)[(stride) * ((width) * (width) + within(u, r))] * (x)[u];                 \
    }

static INLINE_BODY void IN(load)(const vec *Y, vec x[6])
{
    for (int i = 0; i < 6; i++)
        x[i] = Y[S * i];
}

static INLINE_BODY void IN(store)(const vec x[6], vec *Y, vec last[6])
{
    for (int i = 0; i < 6; i++)
        Y[S * i] = last[i] = x[i];
}

static INLINE_BODY void IN(solve_beta)(struct part *p)
{
    int n = p->all->model->n;
    const vec *L = p->factor;
    vec x[6], last[6] = {{0}}, *Y = p->Y;

    for (int k = 0; k <= n; k++, L += S * BLOCK, Y += S * 6) {
        IN(load)(Y, x);
        FORWARD(L, S, 4, last, x)
        FORWARD(L + S * LATERAL, S, 2, last + 4, x + 4)
        IN(store)(x, Y, last);
    }
    for (int i = 0; i < 6; i++)
        last[i] = (vec){0};
    for (int k = n; k >= 0; k--) {
        const vec *N = k < n ? L : L - S * BLOCK; /* behind the last node: any block, times zero */

        L -= S * BLOCK;
        Y -= S * 6;
        IN(load)(Y, x);
        BACKWARD(L, N, S, 4, last, x)
        BACKWARD(L + S * LATERAL, N + S * LATERAL, S, 2, last + 4, x + 4)
        IN(store)(x, Y, last);
    }
}

/* Three components by the factor of M. */
static INLINE_BODY void IN(solve_mass)(struct part *p)
{
    int n = p->all->model->n;
    const double *L = p->all->mass_factor;
    vec x[6], last[6] = {{0}}, *Y = p->Y;

    for (int k = 0; k <= n; k++, L += PAIR, Y += S * 6) {
        IN(load)(Y, x);
        for (int c = 0; c < 6; c += 2)
            FORWARD(L, 1, 2, last + c, x + c)
        IN(store)(x, Y, last);
    }
    for (int i = 0; i < 6; i++)
        last[i] = (vec){0};
    for (int k = n; k >= 0; k--) {
        const double *N = k < n ? L : L - PAIR;

        L -= PAIR;
        Y -= S * 6;
        IN(load)(Y, x);
        for (int c = 0; c < 6; c += 2)
            BACKWARD(L, N, 1, 2, last + c, x + c)
        IN(store)(x, Y, last);
    }
}

/* Y = V(t+dt) - V(t-dt) */
static INLINE_BODY void IN(step_beta)(struct part *p)
{
    size_t n = (size_t)p->all->model->n;
    vec known[6];

    for (size_t k = 0; k <= n; k++)
        for (size_t c = 0; c < 6; c += 2)
            IN(mass)(p, k, c);
    for (size_t i = 0; i < 6; i++) {
        size_t at = S * (6 * n * (i / 3) + 2 * (i % 3));

        known[i] = p->next[i] - p->V[at] + p->D[at];
    }
    IN(hold)(p, known);
    IN(solve_beta)(p);
    for (size_t i = 0; i < S * 6 * (n + 1); i += S) {
        p->D[i] = p->Y[i] - p->D[i];
        p->V[i] += p->D[i];
    }
}

/* scale Y = V(t+dt) - 2 V(t) + V(t-dt) + gamma D */
static INLINE_BODY void IN(step_mass)(struct part *p)
{
    size_t n = (size_t)p->all->model->n;
    vec known[6], scale = p->scale, keep = 1 - p->gamma;

    for (size_t i = 0; i < 6; i++) {
        size_t at = S * (6 * n * (i / 3) + 2 * (i % 3));

        known[i] = (p->next[i] - p->V[at] - keep * p->D[at]) / scale;
    }
    IN(hold)(p, known);
    IN(solve_mass)(p);
    for (size_t i = 0; i < S * 6 * (n + 1); i += S) {
        p->D[i] = keep * p->D[i] + scale * p->Y[i];
        p->V[i] += p->D[i];
    }
}

static INLINE_BODY void IN(step)(struct part *p)
{
    size_t n = (size_t)p->all->model->n;

    if (p->all->terms == 3) /* as a constant: the factors 0 and 1 vanish */
        IN(forces)(p, 3);
    else
        IN(forces)(p, p->all->terms);
    if (p->all->beta)
        IN(step_beta)(p);
    else
        IN(step_mass)(p);
    for (size_t i = 0; i < 6; i++) /* the supports, from V itself: round-off does not add up */
        p->V[S * (6 * n * (i / 3) + 2 * (i % 3))] = p->next[i];
}

/* Register number `at` of a number of all lanes. */
#define PART(x) (((vec *)(x))[at])

/* The motions, one step on, to next. */
static INLINE_BODY void IN(move)(struct lanes *p, int at, vec next[6])
{
    for (int i = 0; i < 6; i++)
        next[i] = (vec){0};
    for (struct lanes_motion *m = p->motion; m < p->motion + p->n_motions; m++) {
        vec c = PART(&m->c) * PART(&m->dc) - PART(&m->s) * PART(&m->ds);
        vec s = PART(&m->s) * PART(&m->dc) + PART(&m->c) * PART(&m->ds);

        PART(&m->c) = c;
        PART(&m->s) = s;
        for (int i = 0; i < 6; i++)
            next[i] += PART(&m->r) * (PART(&m->p[i]) * c + PART(&m->q[i]) * s);
    }
}

STEP_FOR static void STEP(struct lanes *p)
{
    for (int at = 0; at < S; at++) {
        struct part q = {p,
                         (vec *)p->V + at,
                         (vec *)p->D + at,
                         (vec *)p->Y + at,
                         (const vec *)p->factor + at,
                         (const vec *)p->support + at,
                         {{0}},
                         PART(&p->scale),
                         PART(&p->gamma),
                         PART(&p->limit),
                         {0},
                         {0}};

        IN(move)(p, at, q.next);
        IN(step)(&q);
        PART(&p->bad) = q.bad;
        PART(&p->slack) = q.slack;
    }
}

#undef FORWARD
#undef BACKWARD
#undef PART
#undef JOIN_
#undef JOIN
#undef IN
#undef S
#undef vec
#undef mask
#undef part
#undef WIDTH
#undef STEP
#undef STEP_FOR
