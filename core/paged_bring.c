#include "paged.h"

static int stands_in_box(const qv_ray *ray, const qv_pages *pages)
{
    for (unsigned axis = 0; axis < 3; axis++)
        if (qv_paged_beyond(pages, ray, axis) >= pages->cells[axis])
            return 0;
    return 1;
}

void qv_paged_bring(const qv_ray *ray, const qv_volume *volume)
{
    while (!stands_in_box(ray, volume->pages))
        qv_pages_seek(volume->pages, ray->place);
}
