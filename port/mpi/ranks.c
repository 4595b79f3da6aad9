/*
 * ranks.c - MPI.
 */
#include "ranks.h"
#include "error.h"

#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>

static int own, count;

/* ---- Beginning and end ---------------------------------------------------------- */

/* Which rank has failed first, and with which exit status: count and 0 where none has. Laid out
   as MPI_2INT. */
struct failure {
    int rank;
    int status;
};

/* MPI_MINLOC takes the least rank, and the status that stands beside it. */
static struct failure first_failure(int status)
{
    struct failure mine = {status == EXIT_SUCCESS ? count : own, status}, first;
    MPI_Allreduce(&mine, &first, 1, MPI_2INT, MPI_MINLOC, MPI_COMM_WORLD);
    return first;
}

/* What all ranks have in common, such as the command line, rank 0 tells as a single process
   would. */
static int tell_first(const char *line, int status)
{
    struct failure first = first_failure(status);
    if (own == first.rank && own == 0) {
        fprintf(stderr, "%s\n", line);
    } else if (own == first.rank) {
        fprintf(stderr, "%s (rank %d)\n", line, own);
    }
    return first.status;
}

void ranks_agree(void)
{
    int status = first_failure(EXIT_SUCCESS).status;
    if (status != EXIT_SUCCESS) {
        exit(status);
    }
}

static void leave(void)
{
    MPI_Finalize();
}

void ranks_begin(int *argc, char ***argv)
{
    MPI_Init(argc, argv);
    atexit(leave);
    MPI_Comm_rank(MPI_COMM_WORLD, &own);
    MPI_Comm_size(MPI_COMM_WORLD, &count);
    error_set_teller(tell_first);
    if (own != 0 && freopen("/dev/null", "w", stdout) == NULL) {
        system_error("/dev/null", NULL);
    }
    ranks_agree();
}

uint32_t ranks_own(void)
{
    return (uint32_t)own;
}

uint32_t ranks_count(void)
{
    return (uint32_t)count;
}

/* ---- Numbers -------------------------------------------------------------------- */

void ranks_share(uint32_t *numbers, int number_count)
{
    MPI_Bcast(numbers, number_count, MPI_UINT32_T, 0, MPI_COMM_WORLD);
}

void ranks_gather(uint64_t *to, uint64_t mine)
{
    MPI_Gather(&mine, 1, MPI_UINT64_T, to, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
}

void ranks_gather_seconds(double *to, double mine)
{
    MPI_Gather(&mine, 1, MPI_DOUBLE, to, 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);
}

/* ---- Sums ----------------------------------------------------------------------- */

/* Some rows of sums as a rectangle of their own: at most QV_PIXEL_MAX of as many pixels. */
static qv_sums rows_of(void *sums, int rows, MPI_Datatype row)
{
    int bytes;
    MPI_Type_size(row, &bytes);
    size_t numbers = (size_t)bytes / sizeof(uint32_t);
    int32_t width = (int32_t)(numbers / QV_SUM_CHANNELS);
    return (qv_sums){sums, numbers * (size_t)rows, {0, 0, width, rows}};
}

/* An MPI_User_function. MPI hands over as many rows at a time as it likes; all are of frames that
   were checked, so an error would be one of this program. */
static void add_rows(void *from, void *to, int *rows, MPI_Datatype *row)
{
    qv_sums more = rows_of(from, *rows, *row), all = rows_of(to, *rows, *row);
    if (qv_sums_add(&all, &more) != QV_OK) {
        MPI_Abort(MPI_COMM_WORLD, EXIT_DATA);
    }
}

/* Sums that stop at their limit may be added in any order. */
void ranks_add_sums(const qv_sums *sums)
{
    int width = sums->rect.right - sums->rect.left; /* at most QV_PIXEL_MAX, so is the height */
    int height = sums->rect.bottom - sums->rect.top;
    void *from = own == 0 ? MPI_IN_PLACE : sums->sums;
    MPI_Datatype row;
    MPI_Op add;
    MPI_Type_contiguous(width * (int)QV_SUM_CHANNELS, MPI_UINT32_T, &row);
    MPI_Type_commit(&row);
    MPI_Op_create(add_rows, 1, &add);
    MPI_Reduce(from, sums->sums, height, row, add, 0, MPI_COMM_WORLD);
    MPI_Op_free(&add);
    MPI_Type_free(&row);
}
