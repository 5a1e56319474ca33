/* Names and the lines where they stand. */
#include "form/roll.h"
#include "num/mem.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum status roll_begin(struct roll *r, const char *file, struct why *why)
{
    *r = (struct roll){.file = mem_copy(file, strlen(file) + 1)};
    return r->file ? SW_OK : fail_plain(why, SW_NOMEM);
}

enum status roll_add(struct roll *r, const char *name, int line, struct why *why)
{
    if (r->n == r->room) {
        int room = r->room > 0 ? 2 * r->room : 64;
        struct roll_item *item = mem_resize(r->item, (size_t)room, sizeof *item);

        if (!item)
            return fail_plain(why, SW_NOMEM);
        r->item = item;
        r->room = room;
    }
    r->item[r->n] = (struct roll_item){mem_copy(name, strlen(name) + 1), line};
    if (!r->item[r->n].name)
        return fail_plain(why, SW_NOMEM);
    r->n++;
    return SW_OK;
}

void roll_free(struct roll *r)
{
    for (int i = 0; i < r->n; i++)
        free(r->item[i].name);
    free(r->item);
    free(r->file);
    *r = (struct roll){.n = 0};
}

const char *roll_name(const struct roll *r, int i)
{
    return i >= 0 && i < r->n ? r->item[i].name : "";
}

enum status roll_fail(struct why *why, const struct roll *r, int i, const char *format, ...)
{
    char text[512];
    va_list list;

    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    return fail(why, SW_FORMAT, "%.400s:%d: %s", r->file, r->item[i].line, text);
}

/* Merge sort by name: stable, and needs no state beside its arguments. */
static void merge_sort(const struct roll *r, int *at, int *spare, int n)
{
    int half = n / 2, i = 0, j = half, k = 0;

    if (n < 2)
        return;
    merge_sort(r, at, spare, half);
    merge_sort(r, at + half, spare, n - half);
    while (i < half && j < n)
        spare[k++] = strcmp(r->item[at[j]].name, r->item[at[i]].name) < 0 ? at[j++] : at[i++];
    while (i < half)
        spare[k++] = at[i++];
    memcpy(at, spare, (size_t)k * sizeof *at);
}

enum status roll_sort(const struct roll *r, struct roll_index *ret, struct why *why)
{
    int *spare = mem_zeroed((size_t)r->n, sizeof *spare);

    *ret = (struct roll_index){mem_zeroed((size_t)r->n, sizeof *ret->at), r->n};
    if (!spare || !ret->at) {
        free(spare);
        return fail_plain(why, SW_NOMEM);
    }
    for (int i = 0; i < r->n; i++)
        ret->at[i] = i;
    merge_sort(r, ret->at, spare, r->n);
    free(spare);
    for (int i = 0; i < r->n; i++) {
        const struct roll_item *now = &r->item[ret->at[i]];

        if (now->name[0] == '\0')
            return roll_fail(why, r, ret->at[i], "a name is missing");
        if (i > 0 && strcmp(r->item[ret->at[i - 1]].name, now->name) == 0)
            return roll_fail(why, r, ret->at[i], "'%.60s' is there already, in line %d", now->name,
                             r->item[ret->at[i - 1]].line);
    }
    return SW_OK;
}

int roll_find(const struct roll *r, const struct roll_index *index, const char *name)
{
    int low = 0, high = index->n - 1;

    while (low <= high) {
        int middle = low + (high - low) / 2;
        int order = strcmp(r->item[index->at[middle]].name, name);

        if (order == 0)
            return index->at[middle];
        if (order < 0)
            low = middle + 1;
        else
            high = middle - 1;
    }
    return -1;
}

int roll_search(const struct roll *r, const char *name, size_t length)
{
    for (int i = 0; i < r->n; i++)
        if (strlen(r->item[i].name) == length && strncmp(r->item[i].name, name, length) == 0)
            return i;
    return -1;
}
