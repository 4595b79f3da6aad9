/*
 * check.h - the assertions of the tests: cmocka where HAVE_CMOCKA is defined,
 * else a small replacement of the same names that needs a C library only.
 *
 * The replacement prints TAP on standard output ("ok 1 - name"), says where an
 * assertion failed on standard error, and leaves the failed test by longjmp, so
 * that the next one still runs. cmocka prints TAP too where the environment
 * holds CMOCKA_MESSAGE_OUTPUT=TAP. fail_msg needs at least one value after its
 * format.
 */
#ifndef QV_CHECK_H
#define QV_CHECK_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#ifdef HAVE_CMOCKA
#include <cmocka.h>
#else

#include <stdio.h>
#include <string.h>

struct CMUnitTest {
    const char *name;
    void (*test_func)(void **state);
};

typedef int (*check_fixture)(void **state);

static jmp_buf check_exit;

static inline void check_fail(const char *file, int line, const char *format, ...)
{
    va_list values;

    (void)fprintf(stderr, "%s:%d: error: ", file, line);
    va_start(values, format);
    (void)vfprintf(stderr, format, values);
    va_end(values);
    (void)fputc('\n', stderr);
    longjmp(check_exit, 1);
}

static inline void check_condition(int holds, const char *text, const char *file, int line)
{
    if (!holds)
        check_fail(file, line, "%s does not hold", text);
}

/* Numbers compare as uintmax_t, so that values of either sign meet their like. */
static inline void check_equality(uintmax_t a, uintmax_t b, int wanted, const char *file, int line)
{
    if ((a == b) != wanted)
        check_fail(file, line, "%jd %s %jd", (intmax_t)a, wanted ? "is not" : "is", (intmax_t)b);
}

static inline void check_range(uintmax_t value, uintmax_t low, uintmax_t high, const char *file,
                               int line)
{
    if (value < low || value > high)
        check_fail(file, line, "%ju is not within %ju .. %ju", value, low, high);
}

static inline void check_string(const char *a, const char *b, const char *file, int line)
{
    if (strcmp(a, b) != 0)
        check_fail(file, line, "\"%s\" is not \"%s\"", a, b);
}

static inline void check_memory(const void *a, const void *b, size_t size, const char *file,
                                int line)
{
    const unsigned char *left = (const unsigned char *)a;
    const unsigned char *right = (const unsigned char *)b;

    for (size_t i = 0; i < size; i++) {
        if (left[i] != right[i])
            check_fail(file, line, "byte %zu of %zu: 0x%02x is not 0x%02x", i, size, left[i],
                       right[i]);
    }
}

/* Returns 1 if the test ran to its end, 0 if an assertion ended it. */
static inline int check_run(const struct CMUnitTest *test)
{
    void *state = NULL;

    if (setjmp(check_exit) != 0)
        return 0;
    test->test_func(&state);
    return 1;
}

/* Whether what comes before a group, if anything, ran to its end. */
static inline int check_begin(check_fixture set_up)
{
    void *state = NULL;

    if (set_up == NULL)
        return 1;
    if (setjmp(check_exit) != 0)
        return 0;
    return set_up(&state) == 0;
}

/* What comes after a group is cmocka's alone: tear_down must be NULL. */
static inline int check_group(const struct CMUnitTest *tests, size_t count, check_fixture set_up,
                              check_fixture tear_down)
{
    int failures = !check_begin(set_up) || tear_down != NULL;

    printf("1..%zu\n", count);
    for (size_t i = 0; i < count; i++) {
        const int passed = check_run(&tests[i]);

        printf("%s %zu - %s\n", passed ? "ok" : "not ok", i + 1, tests[i].name);
        (void)fflush(stdout);
        failures += !passed;
    }
    return failures;
}

#define assert_true(a)         check_condition((a) ? 1 : 0, #a, __FILE__, __LINE__)
#define assert_false(a)        check_condition((a) ? 0 : 1, "!(" #a ")", __FILE__, __LINE__)
#define assert_null(a)         check_condition((a) == NULL, #a " == NULL", __FILE__, __LINE__)
#define assert_non_null(a)     check_condition((a) != NULL, #a " != NULL", __FILE__, __LINE__)
#define assert_int_equal(a, b) check_equality((uintmax_t)(a), (uintmax_t)(b), 1, __FILE__, __LINE__)
#define assert_int_not_equal(a, b)                                                                 \
    check_equality((uintmax_t)(a), (uintmax_t)(b), 0, __FILE__, __LINE__)
#define assert_in_range(a, low, high)                                                              \
    check_range((uintmax_t)(a), (uintmax_t)(low), (uintmax_t)(high), __FILE__, __LINE__)
#define assert_string_equal(a, b)       check_string((a), (b), __FILE__, __LINE__)
#define assert_memory_equal(a, b, size) check_memory((a), (b), (size), __FILE__, __LINE__)
#define fail_msg(...)                   check_fail(__FILE__, __LINE__, __VA_ARGS__)

#define cmocka_unit_test(function)                                                                 \
    {                                                                                              \
        .name = #function, .test_func = (function)                                                 \
    }
#define cmocka_run_group_tests(tests, set_up, tear_down)                                           \
    check_group((tests), sizeof(tests) / sizeof((tests)[0]), (set_up), (tear_down))

#endif /* HAVE_CMOCKA */

#endif /* QV_CHECK_H */
