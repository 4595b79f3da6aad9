/*
 * sha256.h - the hash of FIPS 180-4, for the manifest.
 */
#ifndef VECTORS_SHA256_H
#define VECTORS_SHA256_H

#include <stdio.h>

enum { SHA256_TEXT = 65 };

/* Hashes the rest of a stream; writes 64 hexadecimal digits and a null. */
void sha256_of_stream(char text[SHA256_TEXT], FILE *stream);

#endif
