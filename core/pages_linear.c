#include "fx_wide.h"
#include "qvol.h"
#include "storage.h"

/* So many bytes from an offset on; the first failure ends it. */
static int read_run(qv_linear *linear, uint8_t *to, uint64_t offset, uint32_t bytes)
{
    int status = linear->read(linear->user, to, offset, bytes);
    linear->reads++;
    linear->bytes += bytes;
    return status < 0 ? status : 0;
}

int qv_linear_read(void *user, void *page, const qv_brick *brick)
{
    qv_linear *linear = (qv_linear *)user;
    const uint16_t *first = brick->block.first, *size = linear->size;
    uint32_t extent[3];
    for (unsigned axis = 0; axis < 3; axis++)
        extent[axis] = (uint32_t)brick->block.end[axis] - first[axis];
    uint32_t voxel = qv_voxel_bytes(linear->storage), row_bytes = size[0] * voxel; /* <= 2^15 */
    uint32_t run = extent[0] * voxel, rows = extent[1], slices = extent[2];
    if (extent[0] == size[0]) { /* rows follow each other in the page as in the volume, */
        run *= rows;
        rows = 1;
        if (extent[1] == size[1]) { /* and so do slices */
            run *= slices;
            slices = 1;
        }
    }
    int status = 0;
    for (uint32_t z = 0; z < slices; z++)
        for (uint32_t y = 0; y < rows && status == 0; y++) {
            uint32_t row = (first[2] + z) * size[1] + first[1] + y; /* <= 2^24 */
            uint64_t offset = fx_wide_product(row, row_bytes) + first[0] * voxel;
            status = read_run(linear, (uint8_t *)page + z * brick->slice + y * brick->row,
                              linear->offset + offset, run);
        }
    return status;
}
