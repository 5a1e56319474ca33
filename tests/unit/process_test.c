/* What ends a process, or befalls it: signals, bugs of callers, closed descriptors, a terminal; and
 * what libraries and the kernel refuse, put in between.  Each in a process of its own. */
#include "check.h"

#include "num/mem.h"
#include "sys/csv.h"
#include "sys/ini.h"
#include "sys/number.h"
#include "sys/opt.h"
#include "sys/out.h"

#include <csv.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <ini.h>
#include <poll.h>
#include <signal.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

void LAPACKE_xerbla(const char *name, int32_t info);
void xerbla_(const char *name, const int32_t *info, int length);

/* Counts of a coverage build, which a signal would lose. */
extern void __gcov_dump(void) __attribute__((weak));
extern void __gcov_reset(void) __attribute__((weak));

static void keep_counts(void)
{
    if (!__gcov_dump || !__gcov_reset)
        return;
    __gcov_dump();
    __gcov_reset(); /* or what comes after would not count */
}

int raise(int sig)
{
    keep_counts();
    return kill(getpid(), sig);
}

void abort(void)
{
    keep_counts();
    signal(SIGABRT, SIG_DFL);
    kill(getpid(), SIGABRT);
    for (;;)
        pause();
}

void _exit(int status)
{
    keep_counts();
    for (;;)
        syscall(SYS_exit_group, status);
}

/* Whether fdopen, ftruncate, csv_init, fclose, fsync fail; what inih says. */
static int no_stream, no_cut, no_parser, no_close, no_sync, parsed;

FILE *fdopen(int fd, const char *mode)
{
    FILE *(*f)(int, const char *);

    *(void **)&f = dlsym(RTLD_NEXT, "fdopen");
    errno = EMFILE;
    return no_stream ? NULL : f(fd, mode);
}

int ftruncate(int fd, off_t length)
{
    errno = EIO;
    return no_cut ? -1 : (int)syscall(SYS_ftruncate, fd, length);
}

int fclose(FILE *stream)
{
    int (*f)(FILE *), status;

    *(void **)&f = dlsym(RTLD_NEXT, "fclose");
    status = f(stream);
    errno = EDQUOT;
    return no_close ? EOF : status;
}

int fsync(int fd)
{
    errno = EIO;
    return no_sync ? -1 : (int)syscall(SYS_fsync, fd);
}

int csv_init(struct csv_parser *p, unsigned char options)
{
    int (*f)(struct csv_parser *, unsigned char);

    *(void **)&f = dlsym(RTLD_NEXT, "csv_init");
    return no_parser || !f ? -1 : f(p, options);
}

int ini_parse_stream(ini_reader reader, void *stream, ini_handler handler, void *user)
{
    (void)reader, (void)stream, (void)handler, (void)user;
    return parsed;
}

static char directory[] = "/tmp/process_test.XXXXXX", said[4096];

static int enter(void **state)
{
    strcpy(strrchr(directory, '.') + 1, "XXXXXX");
    *state = directory;
    return mkdtemp(directory) && chdir(directory) == 0 ? 0 : -1;
}

static int leave(void **state)
{
    (void)state;
    unlink("err");
    return chdir("/") == 0 && rmdir(directory) == 0 ? 0 : -1;
}

/* Run work in a child; its wait status, its stderr to said. */
static int child(void (*work)(void))
{
    int status, fd = open("err", O_RDWR | O_CREAT | O_TRUNC, 0600);
    pid_t pid;
    ssize_t n;

    fflush(NULL);
    pid = fork();
    assert_true(pid >= 0 && fd >= 0);
    if (pid == 0) {
        dup2(fd, 2);
        signal(SIGINT, SIG_DFL); /* a shell in the background has it ignored */
        err_tool("/usr/bin/tool");
        work();
        _exit(0);
    }
    assert_int_equal(waitpid(pid, &status, 0), pid);
    lseek(fd, 0, SEEK_SET);
    n = read(fd, said, sizeof said - 1);
    said[n > 0 ? n : 0] = '\0';
    close(fd);
    return status;
}

static void put(const char *name, const char *text)
{
    FILE *f = fopen(name, "w");

    assert_non_null(f);
    fputs(text, f);
    fclose(f);
}

static void lapacke_bug(void)
{
    LAPACKE_xerbla("LAPACKE_dgesv_work", -1010); /* memory: told by its caller */
    LAPACKE_xerbla("LAPACKE_dgesv_work", -3);
}

static void lapack_bug(void)
{
    const int32_t info = 4;

    xerbla_("DGESV  ", &info, 5);
}

/* A wrong argument is a bug: the process aborts and says whose. */
static void bugs(void **state)
{
    int status = child(lapacke_bug);
    (void)state;

    assert_true(WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT);
    assert_string_equal(said, "tool: bug: argument 3 of LAPACKE_dgesv_work is wrong\n");
    status = child(lapack_bug);
    assert_true(WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT);
    assert_string_equal(said, "tool: bug: argument 4 of DGESV is wrong\n");
}

static struct why why;

static void write_half(void)
{
    static struct out o;

    out_prepare();
    if (out_open(&o, "result", &why) != SW_OK)
        _exit(9);
    fputs("half", o.f);
    fflush(o.f);
    kill(getpid(), SIGTERM);
}

static void write_rows(void)
{
    static struct out o;

    out_prepare();
    signals_defer();
    if (out_open(&o, "result", &why) != SW_OK)
        _exit(9);
    kill(getpid(), SIGINT);
    kill(getpid(), SIGTERM);
    if (signals_pending() != SIGINT)
        _exit(8);
    signals_end(&o);
}

/* As by a parent that has blocked it. */
static void write_blocked(void)
{
    static struct out o;
    sigset_t set;

    out_prepare();
    signals_defer();
    if (out_open(&o, "-", &why) != SW_OK)
        _exit(9);
    kill(getpid(), SIGINT);
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigprocmask(SIG_BLOCK, &set, NULL);
    signals_end(&o);
}

static void signals(void **state)
{
    int status = child(write_half);
    (void)state;

    assert_true(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM);
    assert_int_equal(access("result.part", F_OK), -1);
    status = child(write_rows);
    assert_true(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT); /* the first one */
    assert_int_equal(access("result.part", F_OK), -1);
    status = child(write_blocked);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 128 + SIGINT);
}

static struct rlimit files_before;

static void allow_files(void)
{
    setrlimit(RLIMIT_NOFILE, &files_before);
}

static void close_and_limit(void)
{
    struct rlimit none;

    getrlimit(RLIMIT_NOFILE, &files_before);
    none = files_before;
    none.rlim_cur = 0;
    close(0);
    if (atexit(allow_files) != 0 || setrlimit(RLIMIT_NOFILE, &none) != 0)
        _exit(9);
    out_prepare();
    exit(0);
}

/* Without standard streams, and nothing to put in their place. */
static void closed(void **state)
{
    int status = child(close_and_limit);
    (void)state;

    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 1);
}

static void refusals(void **state)
{
    struct out o;
    struct ini ini;
    struct csv csv;
    struct in in;
    struct stat st;
    double x[3] = {-1, -1, -1};
    (void)state;

    no_stream = 1;
    assert_int_equal(out_open(&o, "a", &why), SW_WRITE);
    assert_non_null(strstr(why.text, "a.part: cannot be written: "));
    assert_int_equal(stat("a.part", &st), -1);
    put("a.part", "0123456789");
    assert_int_equal(out_resume(&o, "a", 4, &why), SW_WRITE);
    assert_int_equal(stat("a.part", &st), 0); /* not ours: what was there stays */
    assert_int_equal(st.st_size, 10);
    no_stream = 0;
    assert_int_equal(out_resume(&o, "a", 11, &why), SW_READ);
    assert_string_equal(why.text, "a: holds 10 bytes; the state was saved after 11");
    no_cut = 1;
    assert_int_equal(out_resume(&o, "a", 4, &why), SW_WRITE);
    assert_non_null(strstr(why.text, "a.part: cannot be cut back: "));
    no_cut = 0;
    assert_int_equal(out_close(&o, &why), SW_OK);
    assert_int_equal(stat("a", &st), 0);
    assert_int_equal(st.st_size, 10);                      /* nothing was cut */
    assert_int_equal(out_resume(&o, "a", 4, &why), SW_OK); /* copied */
    assert_int_equal(out_bytes(&o), 4);
    assert_int_equal(out_keep(&o, &why), SW_OK);
    assert_int_equal(stat("a.part", &st), 0);
    assert_int_equal(st.st_size, 4);
    unlink("a.part");
    no_close = 1;
    assert_int_equal(out_resume(&o, "a", 4, &why), SW_WRITE); /* a copy that may not be whole */
    assert_int_equal(stat("a.part", &st), -1);
    no_close = 0;
    for (int k = 0; k < 2; k++) { /* nor is what was not closed, or did not reach the disk */
        assert_int_equal(out_open(&o, "b", &why), SW_OK);
        fputs("text", o.f);
        *(k ? &no_sync : &no_close) = 1;
        assert_int_equal(out_close(&o, &why), SW_WRITE);
        assert_string_equal(why.text, k ? "b: cannot be written: Input/output error"
                                        : "b: cannot be written: Disk quota exceeded");
        *(k ? &no_sync : &no_close) = 0;
        assert_int_equal(stat("b", &st), -1);
        assert_int_equal(stat("b.part", &st), -1);
    }

    assert_int_equal(in_open("a", &in, &why), SW_OK);
    no_parser = 1;
    assert_int_equal(csv_begin(&in, &csv, &why), SW_NOMEM);
    no_parser = 0;
    in_close(&in);
    unlink("a");

    parsed = -2; /* inih has no memory; a line that it does not like */
    assert_int_equal(ini_read(stdin, "case", &ini, &why), SW_NOMEM);
    ini_free(&ini);
    parsed = 3;
    assert_int_equal(ini_read(stdin, "case", &ini, &why), SW_FORMAT);
    assert_string_equal(why.text, "case:3: expected key = value");
    ini_free(&ini);
    mem_fail_at(1);
    assert_int_equal(ini_read(stdin, "case", &ini, &why), SW_NOMEM);
    assert_int_equal(mem_fail_at(0), 0);
    ini_free(&ini);

    assert_int_equal(numbers_read("1,2,3", 3, x, &why), SW_OK);
    assert_true(x[0] == 1 && x[1] == 2 && x[2] == 3);
    assert_int_equal(numbers_read("1,2", 3, x, &why), SW_USAGE);
    assert_string_equal(why.text, "'1,2': 3 numbers are expected, commas between them");
    assert_int_equal(numbers_read("1,,3", 3, x, &why), SW_USAGE);
    assert_int_equal(numbers_read("1,2,3,4", 3, x, &why), SW_USAGE);
    assert_int_equal(numbers_read("1,x,3", 3, x, &why), SW_USAGE);
    assert_non_null(strstr(why.text, "'x': "));
}

/* A device that may not be written, as another user. */
static void no_device(void)
{
    struct out o;

    if (out_open(&o, "/dev/tty", &why) != SW_WRITE || !strstr(why.text, "/dev/tty: cannot"))
        _exit(1);
}

/* No copy where the result may not be read, or none be written. */
static void no_copy(void)
{
    struct out o;
    int good = chmod(".", 0755) == 0 && seteuid(65534) == 0;

    good = good && out_resume(&o, "shut", 1, &why) == SW_WRITE;
    if (seteuid(0) != 0 || !good || !strstr(why.text, "shut.part: cannot be written: "))
        _exit(1);
}

static void input_is_output(void)
{
    struct in in;
    struct out o;

    dup2(open("both", O_RDWR), 1);
    if (in_open("both", &in, &why) != SW_OK || out_open(&o, "-", &why) != SW_USAGE ||
        strcmp(why.text, "standard output is an input of this run"))
        _exit(1);
}

static void files(void **state)
{
    (void)state;
    put("shut", "text");
    put("both", "text");
    chmod("shut", 0);
    assert_int_equal(child(input_is_output), 0);
    setsid();
    assert_int_equal(child(no_device), 0);
    if (geteuid() == 0)
        assert_int_equal(child(no_copy), 0);
    unlink("shut");
    unlink("both");
}

static int terminal;

/* Half way, at once and a second time too soon, on the terminal or verbosely into a file. */
static void show(void)
{
    if (terminal >= 0)
        dup2(terminal, 2);
    else
        err_level(0, 1);
    progress(0.5, "steps");
    progress(0.6, "steps");
    progress_end();
    err_level(1, 0);
    progress(0.7, "steps");
    progress_end();
}

static void progresses(void **state)
{
    int master = posix_openpt(O_RDWR | O_NOCTTY);
    char text[256] = "";
    (void)state;

    terminal = -1;
    assert_int_equal(child(show), 0);
    assert_string_equal(said, "steps  50 %\n");
    assert_true(master >= 0 && grantpt(master) == 0 && unlockpt(master) == 0);
    terminal = open(ptsname(master), O_RDWR | O_NOCTTY);
    assert_true(terminal >= 0);
    assert_int_equal(child(show), 0);
    for (size_t n = 0; !strstr(text, "\033[K");) { /* a terminal gives it piece by piece */
        struct pollfd ready = {.fd = master, .events = POLLIN};
        ssize_t more;

        assert_int_equal(poll(&ready, 1, 5000), 1);
        more = read(master, text + n, sizeof text - 1 - n);
        assert_true(more > 0);
        n += (size_t)more;
    }
    assert_string_equal(text, "\rsteps  50 %\r\033[K");
    close(terminal);
    close(master);
}

static void take_list(void)
{
    static struct opt_list list;
    static const struct opt options[] = {{"set", 0, OPT_LIST, &list, "TEXT", "take it", 0, 0},
                                         {NULL, 0, OPT_FLAG, NULL, NULL, NULL, 0, 0}};
    static const struct opt_tool tool = {"tool", "", "", options, NULL};
    static char *words[] = {"tool", "--set", "a", NULL};

    mem_fail_at(1);
    opt_parse(&tool, 3, words);
}

static void ask_for_help(void)
{
    static const struct opt options[] = {{NULL, 0, OPT_FLAG, NULL, NULL, NULL, 0, 0}};
    static const struct opt_tool tool = {"tool", "", "", options, NULL};
    static char *words[] = {"tool", "--help", NULL};

    dup2(open("/dev/full", O_WRONLY), 1);
    opt_parse(&tool, 2, words);
}

/* Help that nobody can read is a failure. */
static void no_room_for_help(void **state)
{
    int status = child(ask_for_help);
    (void)state;

    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 1);
    assert_string_equal(said, "tool: <stdout>: cannot be written\n");
}

static void no_room_for_options(void **state)
{
    int status = child(take_list);
    (void)state;

    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 1);
    assert_string_equal(said, "tool: memory ran out\n");
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, enter, leave)

TEST_MAIN(TEST(bugs), TEST(signals), TEST(closed), TEST(refusals), TEST(files), TEST(progresses),
          TEST(no_room_for_help), TEST(no_room_for_options))
