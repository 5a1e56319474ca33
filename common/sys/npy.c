/* NumPy .npy files. */
#include "sys/npy.h"
#include "num/mem.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#if __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "the files hold little-endian numbers: swap bytes in npy_read and npy_write for this machine"
#endif

#define MAX_HEADER 65535 /* bytes; headers of plain arrays have about 100 */

void npy_begin(struct out *o, int dims, size_t rows, size_t columns)
{
    char shape[64], header[192];
    int length;

    if (dims == 1)
        snprintf(shape, sizeof shape, "(%zu,)", rows);
    else
        snprintf(shape, sizeof shape, "(%zu, %zu)", rows, columns);
    length = snprintf(header, sizeof header,
                      "{'descr': '<f8', 'fortran_order': True, 'shape': %s, }", shape);
    while (10 + length + 1 < NPY_HEADER_BYTES) /* a multiple of 64, where data start */
        header[length++] = ' ';
    header[length++] = '\n';
    fwrite("\x93NUMPY\x01\x00", 1, 8, o->f);
    putc(length & 255, o->f);
    putc(length >> 8, o->f);
    fwrite(header, 1, (size_t)length, o->f);
}

void npy_write(struct out *o, int dims, size_t rows, size_t columns, const double *data)
{
    npy_begin(o, dims, rows, columns);
    fwrite(data, sizeof *data, rows * columns, o->f);
}

static enum status bad(const struct in *in, struct why *why, const char *text)
{
    if (ferror(in->f))
        return fail(why, SW_READ, "%s: cannot be read", in->name);
    return fail(why, SW_FORMAT, "%s: %s", in->name, text);
}

/* The header's text, NUL-terminated, to be freed. */
static enum status read_header(const struct in *in, char **ret, struct why *why)
{
    unsigned char start[12];
    size_t length, n = 10;

    *ret = NULL;
    if (fread(start, 1, 10, in->f) != 10 || memcmp(start, "\x93NUMPY", 6) != 0)
        return bad(in, why, "is no .npy file, or cut short");
    length = (size_t)start[8] | (size_t)start[9] << 8;
    if (start[6] == 2) {
        if (fread(start + n, 1, 2, in->f) != 2)
            return bad(in, why, "the header is cut short");
        length |= (size_t)start[10] << 16 | (size_t)start[11] << 24;
    } else if (start[6] != 1)
        return bad(in, why, "is no .npy file of format 1.0 or 2.0");
    if (length > MAX_HEADER)
        return bad(in, why, "the header is absurdly long");
    *ret = mem_zeroed(length + 1, 1);
    if (!*ret)
        return fail_plain(why, SW_NOMEM);
    if (fread(*ret, 1, length, in->f) != length)
        return bad(in, why, "the header is cut short");
    return SW_OK;
}

/* What stands after 'key': in the header's dictionary, or NULL. */
static const char *value_of(const char *header, const char *key)
{
    char quoted[32];
    const char *p;

    snprintf(quoted, sizeof quoted, "'%s':", key);
    p = strstr(header, quoted);
    if (p)
        p += strlen(quoted);
    while (p && *p == ' ')
        p++;
    return p;
}

/* "(3,)" or "(3, 4)". */
static int read_shape(const char *p, struct npy *ret)
{
    size_t extent[2] = {0, 1};
    int dims = 0;

    if (*p++ != '(')
        return 0;
    while (*p != ')') {
        char *end;

        if (dims == 2 || *p < '0' || *p > '9')
            return 0;
        extent[dims] = strtoull(p, &end, 10);
        if (extent[dims++] > SIZE_MAX / 64 || (*end != ',' && *end != ')'))
            return 0;
        p = end + (*end == ',');
        p += strspn(p, " ");
    }
    ret->dims = dims;
    ret->rows = extent[0];
    ret->columns = extent[1];
    return dims > 0 && (extent[1] == 0 || extent[0] <= SIZE_MAX / 64 / extent[1]);
}

static enum status judge_header(const struct in *in, const char *header, int *ret_fortran,
                                struct npy *ret, struct why *why)
{
    const char *descr = value_of(header, "descr"), *order = value_of(header, "fortran_order");
    const char *shape = value_of(header, "shape");

    if (!descr || !order || !shape)
        return bad(in, why, "the header lacks descr, fortran_order or shape");
    if (strncmp(descr, "'<f8'", 5) != 0)
        return bad(in, why, "expected little-endian 64-bit floating point numbers ('<f8')");
    *ret_fortran = strncmp(order, "True", 4) == 0;
    if (!*ret_fortran && strncmp(order, "False", 5) != 0)
        return bad(in, why, "fortran_order must be True or False");
    if (!read_shape(shape, ret))
        return bad(in, why, "expected an array with one or two dimensions");
    return SW_OK;
}

/* Numbers in pieces, so that a header that lies about the size costs no memory. */
static enum status read_data(const struct in *in, struct npy *ret, struct why *why)
{
    size_t wanted = ret->rows * ret->columns, done = 0, room = 0;

    while (done < wanted) {
        size_t piece = wanted - done < 65536 ? wanted - done : 65536;

        if (done + piece > room) {
            double *grown;

            room = done + piece < wanted / 2 ? 2 * (done + piece) : wanted;
            grown = mem_resize(ret->data, room, sizeof *grown);
            if (!grown)
                return fail_plain(why, SW_NOMEM);
            ret->data = grown;
        }
        if (fread(ret->data + done, sizeof *ret->data, piece, in->f) != piece)
            return bad(in, why, "the data are cut short");
        done += piece;
    }
    if (getc(in->f) != EOF)
        return bad(in, why, "more data than the header tells");
    return SW_OK;
}

static enum status turn(struct npy *a, struct why *why)
{
    double *t = mem_doubles(a->rows * a->columns);

    if (!t)
        return fail_plain(why, SW_NOMEM);
    for (size_t i = 0; i < a->rows; i++)
        for (size_t j = 0; j < a->columns; j++)
            t[i + a->rows * j] = a->data[j + a->columns * i];
    free(a->data);
    a->data = t;
    return SW_OK;
}

enum status npy_read(const struct in *in, struct npy *ret, struct why *why)
{
    char *header;
    int fortran = 1;
    enum status s = read_header(in, &header, why);

    *ret = (struct npy){0};
    if (s == SW_OK && header)
        s = judge_header(in, header, &fortran, ret, why);
    free(header);
    if (s == SW_OK)
        s = read_data(in, ret, why);
    if (s == SW_OK && !fortran && ret->dims == 2 && ret->rows * ret->columns > 0)
        s = turn(ret, why);
    if (s != SW_OK)
        npy_free(ret);
    return s;
}

void npy_free(struct npy *a)
{
    free(a->data);
    *a = (struct npy){0};
}
