// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine.H"

#include "lanes.H"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <memory>

using lpfPairs::lanesOf;
using lpfPairs::packOf;

namespace
{

double now()
{
    using clock = std::chrono::steady_clock;
    return std::chrono::duration<double>(clock::now().time_since_epoch())
        .count();
}

//- Time of the processors over the threads: what others take does not count
double processorTime()
{
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (static_cast<double>(t.tv_sec)
            + 1e-9 * static_cast<double>(t.tv_nsec))
         / omp_get_max_threads();
}

//- Independent multiply-adds in registers, on every thread at once
template<class Real>
double peak()
{
    constexpr int chains = 12, repeats = 4000000;
    double used = 0;
    const double begin = processorTime();
#pragma omp parallel reduction(+ : used)
    {
        packOf<Real> a[chains];
        for (int k = 0; k < chains; ++k)
        {
            a[k] = packOf<Real>(static_cast<Real>(1 + k));
        }
        const packOf<Real> b(static_cast<Real>(0.999)),
            c(static_cast<Real>(1e-3));
        for (int r = 0; r < repeats; ++r)
        {
            for (int k = 0; k < chains; ++k)
            {
                a[k] = a[k] * b + c;
            }
        }
        for (int k = 0; k < chains; ++k)
        {
            used += lpfPairs::sum(a[k]);
        }
    }
    const double t = processorTime() - begin;
    const double count =
        1.0 * chains * repeats * lanesOf<Real> * omp_get_max_threads();
    return used > 0 ? count / t : 0;
}

} // namespace

double multiplyAdds()
{
    return peak<double>();
}

double multiplyAddsSingle()
{
    return peak<float>();
}

double memoryBandwidth()
{
    constexpr long n = 16 << 20, repeats = 3;
    const std::unique_ptr<double[]> a(new double[n]), b(new double[n]),
        c(new double[n]);
    double best = 0;
    for (long r = 0; r <= repeats; ++r)
    {
        const double begin = now();
#pragma omp parallel for schedule(static)
        for (long i = 0; i < n; ++i)
        {
            // the first round touches the pages
            a[i] = r == 0 ? 0 : b[i] + 0.5 * c[i];
            if (r == 0)
            {
                b[i] = c[i] = 1;
            }
        }
        const double t = now() - begin;
        best = r == 0 ? best : std::max(best, 3.0 * n * sizeof(double) / t);
    }
    return a[n / 2] > 0 ? best : 0;
}

void printMachine()
{
    std::printf(
        "machine: %d threads, %.1f (double), %.1f (single) 1e9 "
        "multiply-adds/s, %.1f GB/s\n",
        omp_get_max_threads(),
        1e-9 * multiplyAdds(),
        1e-9 * multiplyAddsSingle(),
        1e-9 * memoryBandwidth()
    );
}
