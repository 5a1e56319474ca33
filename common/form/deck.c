/* Mooring decks of other codes: recognized, and read as a whole. */
#include "form/deck.h"
#include "form/deckparts.h"
#include "num/mem.h"
#include "sys/in.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Of one line: 1 and -1 tell that the file is a deck, or is none. */
static int judge_line(char *line)
{
    const char *first = line + strspn(line, " \t\xef\xbb\xbf");

    if (*first == '[')
        return -1;
    line[strcspn(line, "#;")] = '\0';
    return deck_heading(line) > DECK_NONE;
}

enum status deck_recognize(const char *path, int *ret, struct why *why)
{
    char line[200];
    struct stat st;
    struct in in;
    enum status s;
    int verdict = 0, begins = 1;

    *ret = 0;
    if (strcmp(path, "-") == 0 || (stat(path, &st) == 0 && !S_ISREG(st.st_mode)))
        return SW_OK; /* what is read once only is a case */
    s = in_open(path, &in, why);
    if (s != SW_OK)
        return s;
    while (verdict == 0 && fgets(line, sizeof line, in.f)) {
        int ends = strchr(line, '\n') != NULL;

        verdict = begins ? judge_line(line) : 0;
        begins = ends;
    }
    *ret = verdict > 0;
    if (ferror(in.f))
        s = fail(why, SW_READ, "%.400s: cannot be read", path);
    in_close(&in);
    return s;
}

/* Sections without which there is no mooring. */
static enum status judge_sections(const struct deck *d, struct why *why)
{
    static const struct {
        enum deck_section section;
        const char *name;
    } needed[] = {{DECK_TYPES, "LINE TYPES"}, {DECK_POINTS, "POINTS"}, {DECK_LINES, "LINES"}};

    for (size_t k = 0; k < sizeof needed / sizeof *needed; k++) {
        if (d->opened[needed[k].section] == 0)
            return deck_fail(why, d, d->lines, "the file ends without a section %s",
                             needed[k].name);
        if (deck_next(d, needed[k].section, -1) < 0)
            return deck_fail(why, d, d->opened[needed[k].section], "section %s is empty",
                             needed[k].name);
    }
    return SW_OK;
}

static enum status name_all(const struct deck *d, const struct deck_options *o, struct system *p,
                            struct why *why)
{
    struct roll_index types = {NULL, 0};
    enum status s = deck_name_types(d, p, why);

    if (s == SW_OK)
        s = roll_sort(&p->types, &types, why);
    free(types.at);
    if (s == SW_OK)
        s = deck_name_bodies(d, p, why);
    if (s == SW_OK)
        s = deck_name_nodes(d, o, p, why);
    return s == SW_OK ? deck_name_lines(d, o, p, why) : s;
}

static enum status take_all(const struct deck *d, struct system *p, struct why *why)
{
    struct deck_options o;
    enum status s = judge_sections(d, why);

    if (s == SW_OK)
        s = deck_take_options(d, &o, why);
    if (s == SW_OK)
        s = name_all(d, &o, p, why);
    if (s == SW_OK)
        s = system_room(p, why);
    if (s == SW_OK)
        s = deck_pass_options(d, p, why);
    if (s == SW_OK)
        s = deck_take_types(d, p, why);
    if (s == SW_OK)
        s = deck_take_bodies(d, p, why);
    if (s == SW_OK)
        s = deck_take_points(d, &o, p, why);
    if (s == SW_OK)
        s = deck_take_rods(d, p, why);
    return s == SW_OK ? deck_take_lines(d, &o, p, why) : s;
}

enum status deck_load(const char *path, struct system *ret, struct why *why)
{
    struct deck d;
    enum status s = deck_read(path, &d, why);

    if (s != SW_OK)
        return s;
    s = take_all(&d, ret, why);
    deck_free(&d);
    return s;
}
