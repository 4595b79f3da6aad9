/*
 * write.h - generated headers of fixedpoint.
 */
#ifndef WRITE_H
#define WRITE_H

#include <stdint.h>
#include <stdio.h>

/* Opens fixedpoint's header NAME.h in a folder and writes its head; ends the
   program when it cannot. write_close completes the file. */
FILE *write_open(const char *folder, const char *name, const char *about);
void write_close(FILE *file);

void write_number(FILE *file, const char *name, uint32_t value, const char *about);

/* A table of uint16_t or uint32_t, as bits says. */
void write_table(FILE *file, unsigned bits, const char *name, const uint32_t values[],
                 unsigned count, const char *about);

/* One for each header. */
void write_exp(const char *folder);
void write_log(const char *folder);
void write_log8(const char *folder);
void write_phi(const char *folder);

#endif /* WRITE_H */
