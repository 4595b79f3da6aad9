/*
 * quiet.c - standard error goes nowhere for a while.
 */
#define _POSIX_C_SOURCE 200809L

#include "quiet.h"

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

int quiet_begin(void)
{
    int saved;
    int nowhere;
    fflush(stderr);
    saved = dup(STDERR_FILENO);
    nowhere = open("/dev/null", O_WRONLY);
    if (nowhere >= 0) {
        dup2(nowhere, STDERR_FILENO);
        close(nowhere);
    }
    return saved;
}

void quiet_end(int saved)
{
    fflush(stderr);
    if (saved >= 0) {
        dup2(saved, STDERR_FILENO);
        close(saved);
    }
}
