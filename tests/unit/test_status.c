/*
 * Texts of statuses, and the version.
 */
#include "check.h"
#include "qvol.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

/* The errors count down to it. */
#define LAST_ERROR QV_ERROR_PAGES

static const char *text_of(int status)
{
    return qv_status_text((qv_status)status);
}

static void every_status_has_a_line_of_its_own(void **state)
{
    (void)state;

    for (int a = LAST_ERROR; a <= QV_MORE; a++) {
        assert_non_null(text_of(a));
        assert_true(strlen(text_of(a)) > 0);
        assert_null(strchr(text_of(a), '\n'));
        assert_true(strcmp(text_of(a), text_of(QV_MORE + 1)) != 0);
        for (int b = a + 1; b <= QV_MORE; b++)
            assert_true(strcmp(text_of(a), text_of(b)) != 0);
    }
}

static void other_values_have_a_text_too(void **state)
{
    static const int others[] = {QV_MORE + 1, LAST_ERROR - 1, INT_MIN, INT_MAX};
    (void)state;

    for (unsigned i = 0; i < sizeof others / sizeof others[0]; i++)
        assert_string_equal(text_of(others[i]), "unknown status");
}

static void version_is_that_of_the_header(void **state)
{
    char expected[32];
    (void)state;

    (void)snprintf(expected, sizeof expected, "%d.%d.%d", QV_VERSION_MAJOR, QV_VERSION_MINOR,
                   QV_VERSION_PATCH);
    assert_string_equal(QV_VERSION, expected);
    assert_string_equal(qv_version(), QV_VERSION);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_status_has_a_line_of_its_own),
        cmocka_unit_test(other_values_have_a_text_too),
        cmocka_unit_test(version_is_that_of_the_header),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
