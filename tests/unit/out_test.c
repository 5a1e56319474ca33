/* Output files: whole or not at all, links, devices, inputs of the run, signals. */
#include "check.h"

#include "sys/in.h"
#include "sys/out.h"

#include <errno.h>
#include <signal.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

static struct why why;
static char directory[] = "/tmp/out_test.XXXXXX";

/* Each test works in a directory of its own, empty at the end. */
static int enter(void **state)
{
    strcpy(strrchr(directory, '.') + 1, "XXXXXX");
    *state = directory;
    return mkdtemp(directory) && chdir(directory) == 0 ? 0 : -1;
}

static int leave(void **state)
{
    (void)state;
    return chdir("/") == 0 && rmdir(directory) == 0 ? 0 : -1;
}

static void put(const char *name, const char *text)
{
    FILE *f = fopen(name, "w");

    assert_non_null(f);
    fputs(text, f);
    fclose(f);
}

static void holds(const char *name, const char *text)
{
    char bytes[512] = "";
    FILE *f = fopen(name, "r");

    assert_non_null(f);
    bytes[fread(bytes, 1, sizeof bytes - 1, f)] = '\0';
    fclose(f);
    assert_string_equal(bytes, text);
}

static int exists(const char *name)
{
    struct stat st;

    return lstat(name, &st) == 0;
}

static void open_good(struct out *o, const char *name)
{
    if (out_open(o, name, &why) != SW_OK) {
        print_error("%s\n", why.text);
        assert_true(0);
    }
}

static void refused(const char *name, enum status wanted, const char *message)
{
    struct out o;

    assert_int_equal(out_open(&o, name, &why), wanted);
    assert_string_equal(why.text, message);
}

static void whole_or_not_at_all(void **state)
{
    struct out o;
    (void)state;

    put("a", "old\n");
    open_good(&o, "a");
    fputs("new\n", o.f);
    fflush(o.f);
    assert_true(exists("a.part"));
    holds("a", "old\n");
    assert_false(out_failed(&o));
    assert_int_equal(out_close(&o, &why), SW_OK);
    assert_null(o.f);
    holds("a", "new\n");
    assert_false(exists("a.part"));
    unlink("a");
}

static void two_halves(void **state)
{
    struct out o;
    (void)state;

    open_good(&o, "a");
    fputs("text", o.f);
    assert_int_equal(out_finish(&o, &why), SW_OK);
    holds("a.part", "text");
    assert_false(exists("a"));
    assert_int_equal(out_rename(&o, &why), SW_OK);
    holds("a", "text");
    assert_false(exists("a.part"));
    unlink("a");
}

static void numbers(void **state)
{
    struct out o;
    (void)state;

    open_good(&o, "a");
    out_number(&o, 0.1);
    putc('\n', o.f);
    out_row(&o, (double[]){1, -0.0, 1.0 / 3}, 3);
    out_row(&o, (double[]){1e300}, 1);
    assert_int_equal(out_close(&o, &why), SW_OK);
    holds("a", "0.1\n1,0,0.3333333333333333\n1e300\n");
    unlink("a");
}

static void links(void **state)
{
    struct out o;
    struct stat st;
    (void)state;

    assert_int_equal(mkdir("d", 0777), 0);
    put("d/target", "old");
    assert_int_equal(symlink("d/target", "link"), 0);
    open_good(&o, "link");
    fputs("new", o.f);
    assert_true(exists("d/target.part"));
    assert_int_equal(out_close(&o, &why), SW_OK);
    assert_true(lstat("link", &st) == 0 && S_ISLNK(st.st_mode));
    holds("d/target", "new");
    unlink("d/target");
    refused("link", SW_WRITE, "link: the link leads nowhere: No such file or directory");
    assert_false(exists("d/target"));
    unlink("link");
    rmdir("d");
}

/* What others put at the name of the unfinished file is not written to. */
static void foreign_part(void **state)
{
    struct out o;
    struct stat st;
    (void)state;

    put("victim", "kept");
    assert_int_equal(symlink("victim", "a.part"), 0);
    open_good(&o, "a");
    fputs("new", o.f);
    assert_true(lstat("a.part", &st) == 0 && S_ISREG(st.st_mode));
    assert_int_equal(out_close(&o, &why), SW_OK);
    holds("a", "new");
    holds("victim", "kept");
    assert_int_equal(link("victim", "a.part"), 0);
    open_good(&o, "a");
    fputs("newer", o.f);
    assert_int_equal(out_close(&o, &why), SW_OK);
    holds("a", "newer");
    holds("victim", "kept");
    unlink("a");
    unlink("victim");
}

static void devices(void **state)
{
    struct out o;
    (void)state;

    open_good(&o, "/dev/null");
    fputs("text", o.f);
    assert_int_equal(out_close(&o, &why), SW_OK);
    assert_false(exists("/dev/null.part"));
    open_good(&o, "/dev/full");
    fputs("text", o.f);
    assert_int_equal(out_close(&o, &why), SW_WRITE);
    assert_string_equal(why.text, "/dev/full: cannot be written: No space left on device");
    open_good(&o, "/dev/full");
    for (int i = 0; i < 100000 && !out_failed(&o); i++)
        fputs("text", o.f);
    assert_true(out_failed(&o));
    assert_int_equal(out_close(&o, &why), SW_WRITE);
}

/* No room for all of the file: neither it nor what was written stays. */
static void disk_full(void **state)
{
    struct rlimit limit, small;
    struct out o;
    (void)state;

    put("a", "old");
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &limit), 0);
    small = limit;
    small.rlim_cur = 100;
    signal(SIGXFSZ, SIG_IGN);
    open_good(&o, "a");
    for (int i = 0; i < 100; i++)
        fputs("text", o.f);
    setrlimit(RLIMIT_FSIZE, &small);
    assert_int_equal(out_close(&o, &why), SW_WRITE);
    setrlimit(RLIMIT_FSIZE, &limit);
    signal(SIGXFSZ, SIG_DFL);
    assert_string_equal(why.text, "a: cannot be written: File too large");
    assert_null(o.f);
    assert_false(exists("a.part"));
    holds("a", "old");
    unlink("a");
}

static void wrong_places(void **state)
{
    char longest[PATH_MAX + 10];
    (void)state;

    memset(longest, 'a', sizeof longest - 1);
    longest[sizeof longest - 1] = '\0';
    assert_int_equal(mkdir("d", 0777), 0);
    put("f", "");
    refused("d", SW_WRITE, "d: is a directory; a file is expected");
    refused("none/a", SW_WRITE, "none/a.part: cannot be written: No such file or directory");
    refused("f/a", SW_WRITE, "f/a.part: cannot be written: Not a directory");
    assert_int_equal(mkdir("g.part", 0777), 0);
    refused("g", SW_WRITE, "g.part: cannot be written: Is a directory");
    for (size_t n = PATH_MAX - 6; n <= PATH_MAX + 2; n++) {
        struct out o;

        longest[n] = '\0';
        assert_int_equal(out_open(&o, longest, &why), SW_WRITE);
        longest[n] = 'a';
    }
    unlink("f");
    rmdir("d");
    rmdir("g.part");
}

/* A directory appears where the file should go: the unfinished file does not stay. */
static void rename_fails(void **state)
{
    struct out o;
    pid_t child = fork();
    int status = 0;
    (void)state;

    if (child == 0) { /* what is left vanishes at the end of the process */
        out_prepare();
        if (out_open(&o, "a", &why) != SW_OK || mkdir("a", 0777) != 0)
            _exit(3);
        exit(out_close(&o, &why) == SW_WRITE ? 0 : 1);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    assert_false(exists("a.part"));
    assert_int_equal(rmdir("a"), 0);
}

static void no_input_is_written(void **state)
{
    struct in in;
    struct stat st;
    (void)state;

    put("case", "text");
    assert_int_equal(link("case", "hard"), 0);
    assert_int_equal(symlink("case", "soft"), 0);
    put("other.part", "text");
    assert_int_equal(in_open("case", &in, &why), SW_OK);
    in_close(&in);
    refused("case", SW_USAGE, "case: is an input of this run");
    refused("./case", SW_USAGE, "./case: is an input of this run");
    refused("hard", SW_USAGE, "hard: is an input of this run");
    refused("soft", SW_USAGE, "soft: is an input of this run");
    assert_int_equal(in_open("other.part", &in, &why), SW_OK);
    in_close(&in);
    refused("other", SW_USAGE, "other.part: is an input of this run");
    holds("case", "text");
    holds("other.part", "text");
    assert_true(stat("case", &st) == 0 && in_was_read(&st));
    unlink("hard");
    unlink("soft");
    unlink("case");
    unlink("other.part");
}

/* As many files as are guarded, and not one more. */
static void many_files(void **state)
{
    struct out o[17];
    char name[17][16];
    int n = 0;
    (void)state;

    for (; n < 17; n++) {
        snprintf(name[n], sizeof name[n], "f%d", n);
        if (out_open(&o[n], name[n], &why) != SW_OK)
            break;
    }
    assert_int_equal(n, 16);
    assert_string_equal(why.text, "f16: too many files are open");
    for (int i = 0; i < n; i++) {
        assert_int_equal(out_close(&o[i], &why), SW_OK);
        unlink(name[i]);
    }
    open_good(&o[0], "f16");
    assert_int_equal(out_close(&o[0], &why), SW_OK);
    unlink("f16");
}

static void inputs(void **state)
{
    struct in in;
    (void)state;

    assert_int_equal(in_open("none", &in, &why), SW_READ);
    assert_string_equal(why.text, "none: cannot be opened: No such file or directory");
    assert_int_equal(in_open(".", &in, &why), SW_READ);
    assert_string_equal(why.text, ".: is a directory; a file is expected");
    assert_int_equal(in_open("", &in, &why), SW_READ);
    assert_int_equal(in_open("-", &in, &why), SW_OK);
    assert_ptr_equal(in.f, stdin);
    assert_string_equal(in.name, "<stdin>");
    in_close(&in);
    assert_null(in.f);
}

/* What a child that writes to "a" does when the signals come; ends by the signal. */
static void be_stopped(int deferred, const int *signals, int n)
{
    struct out o;

    out_prepare();
    if (out_open(&o, "a", &why) != SW_OK || !exists("a.part"))
        _exit(3);
    if (deferred)
        signals_defer();
    for (int i = 0; i < n; i++)
        raise(signals[i]);
    if (signals_pending() != signals[0])
        _exit(4);
    if (!exists("a.part"))
        _exit(5);
    signals_end(&o);
}

static void stopped(int deferred, const int *signals, int n, int wanted)
{
    pid_t child = fork();
    int status = 0;

    if (child == 0) {
        for (int i = 0; i < n; i++)
            signal(signals[i], SIG_DFL); /* nohup has them ignored */
        be_stopped(deferred, signals, n);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    if (WIFEXITED(status))
        print_error("exit status %d\n", WEXITSTATUS(status));
    assert_true(WIFSIGNALED(status));
    assert_int_equal(WTERMSIG(status), wanted);
    assert_false(exists("a"));
    assert_false(exists("a.part"));
}

static void signals(void **state)
{
    static const int ending[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};
    (void)state;

    for (size_t i = 0; i < sizeof ending / sizeof *ending; i++)
        stopped(0, &ending[i], 1, ending[i]);
    stopped(1, (int[]){SIGINT}, 1, SIGINT);
    stopped(1, (int[]){SIGTERM}, 1, SIGTERM);
    stopped(1, (int[]){SIGTERM, SIGTERM}, 2, SIGTERM); /* timeout(1) sends it twice */
    stopped(1, (int[]){SIGINT, SIGTERM}, 2, SIGINT);   /* the first one counts */
    stopped(1, (int[]){SIGHUP}, 1, SIGHUP);
}

#define IN_DIRECTORY(test) cmocka_unit_test_setup_teardown(test, enter, leave)

TEST_MAIN(IN_DIRECTORY(whole_or_not_at_all), IN_DIRECTORY(two_halves), IN_DIRECTORY(numbers),
          IN_DIRECTORY(links), IN_DIRECTORY(foreign_part), IN_DIRECTORY(devices),
          IN_DIRECTORY(disk_full), IN_DIRECTORY(wrong_places), IN_DIRECTORY(rename_fails),
          IN_DIRECTORY(no_input_is_written), IN_DIRECTORY(many_files), IN_DIRECTORY(inputs),
          IN_DIRECTORY(signals))
