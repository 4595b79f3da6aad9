/*
 * quiet.h - standard error goes nowhere while a library runs: its chatter would
 * stand beside the one line that the command prints.
 */
#ifndef QVOL_HOST_QUIET_H
#define QVOL_HOST_QUIET_H

/* Returns what quiet_end needs. */
int quiet_begin(void);
void quiet_end(int saved);

#endif
