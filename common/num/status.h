/*
 * The list of failures: name, exit status of a tool that ends with it, text.
 *
 * Functions of num and phys return one of these and never print or exit.  Exit status 1 says that
 * there is no valid result, 2 that the input or the usage is wrong.
 */
#ifndef SEILWERK_NUM_STATUS_H
#define SEILWERK_NUM_STATUS_H

#define STATUS_LIST(X)                                                                             \
    X(SW_OK, 0, "done")                                                                            \
    X(SW_NOMEM, 1, "memory ran out")                                                               \
    X(SW_NOCONV, 1, "the iteration did not converge")                                              \
    X(SW_INDEFINITE, 1, "a matrix that must be positive definite is not")                          \
    X(SW_INFEASIBLE, 1, "nothing has the wanted property")                                         \
    X(SW_DIVERGED, 1, "the time integration diverged")                                             \
    X(SW_WRITE, 1, "the result could not be written")                                              \
    X(SW_ADMISSIBLE, 2, "an input lies outside of its admissible range")                           \
    X(SW_READ, 2, "the input could not be read")                                                   \
    X(SW_FORMAT, 2, "the input is not in the expected form")                                       \
    X(SW_USAGE, 2, "wrong usage")

enum status {
#define X(name, exit_status, text) name,
    STATUS_LIST(X)
#undef X
};

/* Exit status (0, 1 or 2) of a tool that ends with s. */
int status_exit(enum status s);

/* Text of s, without a final full stop; static storage. */
const char *status_text(enum status s);

#endif
