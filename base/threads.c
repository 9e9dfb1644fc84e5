/* Threads within a rank. */
#include "base/threads.h"
#include "base/ensure.h"

#include <sched.h>
#ifdef _OPENMP
#    include <omp.h>
#endif

static int count = 1;

int threads_set(int threads) {
    ENSURE(threads >= 1 && threads <= THREADS_MAX, "%d threads", threads);
#ifdef _OPENMP
    count = threads;
    return 1;
#else
    return threads == 1;
#endif
}

int threads_count(void) { return count; }

int threads_me(void) {
#ifdef _OPENMP
    return count > 1 ? omp_get_thread_num() : 0;
#else
    return 0;
#endif
}

int threads_cores(void) {
    cpu_set_t cores;
    return sched_getaffinity(0, sizeof cores, &cores) == 0 ? CPU_COUNT(&cores) : 0;
}

void threads_run(void (*work)(int thread, void *data), void *data) {
    if (count == 1) {
        work(0, data);
        return;
    }
#ifdef _OPENMP
    omp_set_dynamic(0);
#    pragma omp parallel num_threads(count)
    {
        ENSURE(omp_get_num_threads() == count, "%d threads given, %d asked", omp_get_num_threads(), count);
        work(omp_get_thread_num(), data);
    }
#endif
}

void threads_wait(void) {
#ifdef _OPENMP
    if (count > 1) {
#    pragma omp barrier
    }
#endif
}

void threads_share(int n, int unit, int thread, int *from, int *to) {
    const long units = (n + unit - 1) / unit;
    const long first = units * thread / count * unit, next = units * (thread + 1) / count * unit;
    *from = first < n ? (int)first : n;
    *to = next < n ? (int)next : n;
}
