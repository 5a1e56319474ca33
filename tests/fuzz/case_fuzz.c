/* Any bytes as a case: refused with words, or resolved; the resolved case resolves to itself. */
#include "form/cable.h"
#include "fuzz.h"

#include <string.h>

/* c as printed; to be freed. */
static char *printed(const struct cable_case *c, size_t *ret_size)
{
    char *text = NULL;
    struct out o = {.slot = -1};

    o.f = open_memstream(&text, ret_size);
    check(o.f);
    case_print(c, &o);
    fclose(o.f);
    return text;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static struct cable_case c, again;
    FILE *f;
    struct why why = {""};
    enum status s;

    if (size > 0 && memmem(data, size, "frequency", 9) && memmem(data, size, "elements", 8))
        return 0; /* the modes of a large model take their time */
    f = bytes(data, size);
    s = case_read(f, "fuzz", NULL, &c, &why);
    fclose(f);
    check((s == SW_OK) == (why.text[0] == '\0'));
    if (s == SW_OK) {
        size_t n, m;
        char *once = printed(&c, &n), *twice;

        f = bytes((const uint8_t *)once, n);
        s = case_read(f, "again", NULL, &again, &why);
        fclose(f);
        if (s != SW_OK)
            fprintf(stderr, "%s\n%s\n", once, why.text);
        check(s == SW_OK);
        check(!case_model_difference(&c, &again));
        twice = printed(&again, &m);
        check(n == m && memcmp(once, twice, n) == 0);
        case_free(&again);
        case_free(&c);
        free(once);
        free(twice);
    }
    return 0;
}
