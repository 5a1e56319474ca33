/* Any bytes as a state to start from: refused with words, or displacements and velocities that are
 * numbers. */
#include "form/state.h"
#include "fuzz.h"

#include <math.h>
#include <string.h>
#include <unistd.h>

static const char text[] = "[cable]\nunstressed_length = 103\nmass_per_length = 2\n"
                           "axial_stiffness = 1e6\n[supports]\nspan = 100\n[mesh]\nelements = 2\n";

static struct model m;

static void prepare(void)
{
    struct cable_case c;
    struct why why = {""};
    FILE *f = bytes((const uint8_t *)text, sizeof text - 1);

    check(case_read(f, "fuzz", NULL, &c, &why) == SW_OK);
    fclose(f);
    check(model_new(&c.cable, c.law, c.elements, &m) == SW_OK);
    case_free(&c);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char path[] = "/tmp/state-fuzz-XXXXXX";
    int fd = mkstemp(path);
    double *V, *W;
    struct why why = {""};
    enum status s;

    if (m.n == 0)
        prepare();
    check(fd >= 0 && write(fd, data, size) == (ssize_t)size && close(fd) == 0);
    V = model_vector(&m);
    W = model_vector(&m);
    check(V && W);
    s = state_start(path, &m, V, W, &why);
    check((s == SW_OK) == (why.text[0] == '\0'));
    for (size_t i = 0; i < model_unknowns(&m) && s == SW_OK; i++)
        check(isfinite(V[i]) && isfinite(W[i]));
    free(V);
    free(W);
    remove(path);
    return 0;
}
