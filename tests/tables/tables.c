/*
 * tables.c - writes the tables of fixedpoint: tables FOLDER
 */
#include "write.h"

#include <mpfr.h>
#include <stdlib.h>

int main(int count, char **arguments)
{
    if (count != 2) {
        fprintf(stderr, "usage: tables FOLDER\n");
        return EXIT_FAILURE;
    }
    write_exp(arguments[1]);
    write_log(arguments[1]);
    write_log8(arguments[1]);
    write_phi(arguments[1]);
    mpfr_free_cache();
    return EXIT_SUCCESS;
}
