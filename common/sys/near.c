/* Words that differ by a slip of the hand. */
#include "sys/near.h"

#include <string.h>

int near_word(const char *a, const char *b)
{
    size_t n = strlen(a), m = strlen(b), i = 0;

    if (n > m)
        return near_word(b, a);
    while (a[i] != '\0' && a[i] == b[i])
        i++;
    return m - n <= 1 && strcmp(a + i + (n == m && i < n), b + i + (i < m)) == 0;
}
