/* Any bytes as a CSV file: rows until the end or an error, lines ascending, cells terminated. */
#include "fuzz.h"
#include "sys/csv.h"

#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct in in = {.f = bytes(data, size), .name = "fuzz"};
    struct csv csv;
    struct why why;
    int line = 0;

    check(csv_begin(&in, &csv, &why) == SW_OK);
    if (csv_header(&csv, &why) == SW_OK)
        while (csv_row(&csv, &why) == SW_OK && csv.n > 0) {
            check(csv.line > line);
            line = csv.line;
            for (int i = 0; i < csv.n; i++) {
                double x;

                check(strlen(csv.cell[i]) <= size);
                csv_number(&csv, i, &x, &why);
            }
        }
    csv_end(&csv);
    fclose(in.f);
    return 0;
}
