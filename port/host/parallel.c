/*
 * parallel.c - threads take piece after piece until none is left.
 */
#define _POSIX_C_SOURCE 200809L

#include "parallel.h"
#include "error.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

struct queue {
    const struct parallel *work;
    pthread_mutex_t lock;
    uint32_t next;
    uint32_t done;
};

unsigned parallel_threads(unsigned asked)
{
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    if (asked != 0) {
        return asked;
    }
    return processors > 0 && processors < THREADS_MOST ? (unsigned)processors : 1;
}

/* Never more threads than pieces. */
static unsigned thread_count(const struct parallel *work)
{
    unsigned threads = parallel_threads(work->threads);
    return threads < work->pieces ? threads : work->pieces;
}

/* Called with the lock held. */
static void show_progress(const struct queue *queue)
{
    const struct parallel *work = queue->work;
    if (work->progress != NULL) {
        unsigned percent = (unsigned)((uint64_t)queue->done * 100 / work->pieces);
        fprintf(stderr, "\r%s %3u %%", work->progress, percent);
    }
}

/* What each thread does; the lock is held but while a piece runs. */
static void *work_off(void *argument)
{
    struct queue *queue = argument;
    const struct parallel *work = queue->work;
    pthread_mutex_lock(&queue->lock);
    while (queue->next < work->pieces) {
        uint32_t piece = queue->next++;
        pthread_mutex_unlock(&queue->lock);
        work->run(work->context, piece);
        pthread_mutex_lock(&queue->lock);
        queue->done++;
        show_progress(queue);
    }
    pthread_mutex_unlock(&queue->lock);
    return NULL;
}

void parallel_run(const struct parallel *work)
{
    struct queue queue = {.work = work, .next = 0, .done = 0};
    unsigned threads = thread_count(work);
    pthread_t others[THREADS_MOST];
    unsigned started = 0;
    pthread_mutex_init(&queue.lock, NULL);
    while (started + 1 < threads && pthread_create(&others[started], NULL, work_off, &queue) == 0) {
        started++;
    }
    work_off(&queue); /* fewer threads than asked for only take longer */
    for (unsigned i = 0; i < started; i++) {
        pthread_join(others[i], NULL);
    }
    pthread_mutex_destroy(&queue.lock);
    if (work->progress != NULL) {
        fprintf(stderr, "\r%*s\r", 40, "");
    }
}

const char *progress_label(bool quiet, const char *label)
{
    return !quiet && isatty(STDERR_FILENO) ? label : NULL;
}
