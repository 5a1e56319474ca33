/* Exit status and text of each failure. */
#include "num/status.h"

static const struct {
    int exit_status;
    const char *text;
} table[] = {
#define X(name, exit_status, text) {exit_status, text},
    STATUS_LIST(X)
#undef X
};

int status_exit(enum status s)
{
    return table[s].exit_status;
}

const char *status_text(enum status s)
{
    return table[s].text;
}
