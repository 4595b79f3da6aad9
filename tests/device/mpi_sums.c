/*
 * mpi_sums.c - sums of all ranks, some of them beyond the limit, against sums of 64 bits. Run by
 * mpirun; says "sums of N ranks agree".
 */
#include "error.h"
#include "ranks.h"

#include <stdio.h>
#include <stdlib.h>

/* A frame of one pixel, one of odd sides, and one of more than MPI sends in a piece. */
static const int32_t sizes[][2] = {{1, 1}, {37, 29}, {700, 500}};

/* Of every 8 numbers some stay small, some reach half of the limit, some are full already. */
static uint32_t number_of(uint32_t rank, size_t place)
{
    uint32_t bits = ((uint32_t)place * 2654435761u) ^ (rank * 2246822519u);
    bits = (bits ^ (bits >> 15)) * 0x85EBCA6Bu;
    switch (place % 8) {
    case 0:
        return rank == place / 8 % ranks_count() ? UINT32_MAX : bits >> 8;
    case 1:
        return UINT32_MAX / ranks_count(); /* at most full, and by the next case just so */
    case 2:
        return UINT32_MAX / ranks_count() + (rank == 0 ? UINT32_MAX % ranks_count() : 0);
    case 3:
        return bits >> 1;
    default:
        return bits >> 8;
    }
}

static uint32_t expected(size_t place)
{
    uint64_t sum = 0;
    for (uint32_t rank = 0; rank < ranks_count(); rank++) {
        sum += number_of(rank, place);
    }
    return sum < UINT32_MAX ? (uint32_t)sum : UINT32_MAX;
}

/* Rank 0 has the sums, the others what they had. */
static void compare(const uint32_t *sums, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        uint32_t wanted = ranks_own() == 0 ? expected(i) : number_of(ranks_own(), i);
        if (sums[i] != wanted) {
            data_error("sums", NULL, "number %zu is %u, not %u", i, sums[i], wanted);
        }
    }
}

static void try_size(const int32_t size[2])
{
    size_t count = (size_t)size[0] * (size_t)size[1] * QV_SUM_CHANNELS;
    uint32_t *numbers = allocate(count * sizeof *numbers, "sums", NULL);
    qv_sums sums = {numbers, count, {-3, 5, size[0] - 3, size[1] + 5}};
    for (size_t i = 0; i < count; i++) {
        numbers[i] = number_of(ranks_own(), i);
    }
    ranks_add_sums(&sums);
    compare(numbers, count);
    ranks_agree();
    free(numbers);
}

int main(int argc, char **argv)
{
    ranks_begin(&argc, &argv);
    for (unsigned i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        try_size(sizes[i]);
    }
    printf("sums of %u ranks agree\n", ranks_count());
    return EXIT_SUCCESS;
}
