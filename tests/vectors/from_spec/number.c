#include "number.h"

#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

/* The store grows by blocks that stay where they are, as numbers are pointers to them. */
enum { BLOCK = 4096, BLOCKS_MAX = 4096 };

static mpz_t *blocks[BLOCKS_MAX];
static size_t made; /* numbers in the blocks that mpz_init has seen */
static size_t used; /* of them, those that stand for something */
static size_t kept;
static const char *where = "";

void fail(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fprintf(stderr, "vectors from SPEC.md: %s: ", where);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(EXIT_FAILURE);
}

void numbers_at(const char *place)
{
    where = place;
}

void numbers_keep(void)
{
    kept = used;
}

void numbers_forget(void)
{
    used = kept;
}

static mpz_ptr take(void)
{
    const size_t block = used / BLOCK;
    if (block == BLOCKS_MAX)
        fail("too many numbers");
    if (blocks[block] == NULL)
        blocks[block] = malloc(BLOCK * sizeof *blocks[block]);
    if (blocks[block] == NULL)
        fail("out of memory");
    mpz_ptr fresh = blocks[block][used % BLOCK];
    if (used == made) {
        mpz_init(fresh);
        made++;
    }
    used++;
    return fresh;
}

number whole(int64_t value)
{
    const uint64_t size = value < 0 ? -(uint64_t)value : (uint64_t)value;
    mpz_ptr r = take();
    mpz_import(r, 1, -1, sizeof size, 0, 0, &size);
    if (value < 0)
        mpz_neg(r, r);
    return r;
}

number power2(unsigned n)
{
    return up(whole(1), n);
}

number parse(const char *decimal)
{
    mpz_ptr r = take();
    return mpz_set_str(r, decimal, 10) == 0 ? r : NULL;
}

number add(number a, number b)
{
    mpz_ptr r = take();
    mpz_add(r, a, b);
    return r;
}

number sub(number a, number b)
{
    mpz_ptr r = take();
    mpz_sub(r, a, b);
    return r;
}

number mul(number a, number b)
{
    mpz_ptr r = take();
    mpz_mul(r, a, b);
    return r;
}

number negative(number a)
{
    mpz_ptr r = take();
    mpz_neg(r, a);
    return r;
}

number magnitude(number a)
{
    mpz_ptr r = take();
    mpz_abs(r, a);
    return r;
}

number floor_div(number a, number b)
{
    if (mpz_sgn(b) == 0)
        fail("division by 0");
    mpz_ptr r = take();
    mpz_fdiv_q(r, a, b);
    return r;
}

number up(number a, unsigned n)
{
    mpz_ptr r = take();
    mpz_mul_2exp(r, a, n);
    return r;
}

number down(number a, unsigned n)
{
    mpz_ptr r = take();
    mpz_fdiv_q_2exp(r, a, n);
    return r;
}

number rounded(number a, unsigned n)
{
    return down(add(a, power2(n - 1)), n);
}

number low_bits(number a, unsigned n)
{
    mpz_ptr r = take();
    mpz_fdiv_r_2exp(r, a, n);
    return r;
}

number either(number a, number b)
{
    mpz_ptr r = take();
    mpz_xor(r, a, b);
    return r;
}

number least(number a, number b)
{
    return is_less(b, a) ? b : a;
}

number most(number a, number b)
{
    return is_less(a, b) ? b : a;
}

number clamp(number a, number from, number to)
{
    return most(from, least(a, to));
}

number with_sign(number size, number of)
{
    return sign_of(of) < 0 ? negative(size) : size;
}

int sign_of(number a)
{
    return mpz_sgn(a);
}

bool is_less(number a, number b)
{
    return mpz_cmp(a, b) < 0;
}

bool is_equal(number a, number b)
{
    return mpz_cmp(a, b) == 0;
}

unsigned bits_of(number a)
{
    return mpz_sgn(a) == 0 ? 0 : (unsigned)mpz_sizeinbase(a, 2);
}

long small(number a)
{
    if (!mpz_fits_slong_p(a))
        fail("a count has %u bits", bits_of(a));
    return mpz_get_si(a);
}

bool bit_of(number a, unsigned n)
{
    return mpz_tstbit(a, n) != 0;
}

number fits_unsigned(number a, unsigned width)
{
    if (mpz_sgn(a) < 0 || bits_of(a) > width) {
        char *text = mpz_get_str(NULL, 10, a);
        fail("%s does not fit u%u", text, width);
    }
    return a;
}

number fits_signed(number a, unsigned width)
{
    /* -2^(width-1) fits, though its magnitude has width bits. */
    number size = mpz_sgn(a) < 0 ? sub(whole(-1), a) : a;
    if (bits_of(size) > width - 1) {
        char *text = mpz_get_str(NULL, 10, a);
        fail("%s does not fit s%u", text, width);
    }
    return a;
}
