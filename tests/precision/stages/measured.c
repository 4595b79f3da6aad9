#include "stages.h"

#include <stdarg.h>
#include <stdio.h>

void measured_input(measured *m, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    (void)vsnprintf(m->input, sizeof m->input, format, values);
    va_end(values);
}

double measured_rms(const measured *m)
{
    return m->count == 0 ? 0 : (double)sqrtl(m->squares / (long double)m->count);
}
