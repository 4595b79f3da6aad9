/* Fields of several numbers. */
#include "stages.h"

void in_all(csv *c, const char *name, number value[], unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        value[i] = in(c, "%s%u", name, i);
}

void out_all(csv *c, const char *name, const number value[], unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        out(c, value[i], "%s%u", name, i);
}

triple in_triple(csv *c, const char *name)
{
    triple t;
    in_all(c, name, t.v, 3);
    return t;
}

void out_triple(csv *c, const char *name, const triple *value)
{
    out_all(c, name, value->v, 3);
}
