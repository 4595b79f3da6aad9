/*
 * paper.c - volumes, views, files and tables of the papers.
 */
#include "paper.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void paper_require(bool condition, const char *what)
{
    if (!condition) {
        fprintf(stderr, "papers: %s\n", what);
        exit(EXIT_FAILURE);
    }
}

void *paper_memory(size_t count, size_t bytes)
{
    void *memory = calloc(count, bytes);
    paper_require(memory != NULL, "out of memory");
    return memory;
}

uint16_t paper_channel(double fraction)
{
    return (uint16_t)floor(fraction * PAPER_FULL + 0.5);
}

static uint32_t q16(double length)
{
    return (uint32_t)floor(length * QV_ONE_Q16 + 0.5);
}

/* ---- Volumes -------------------------------------------------------------- */

void paper_volume_make(paper_volume *made, unsigned nx, unsigned ny, unsigned nz)
{
    const unsigned size[3] = {nx, ny, nz};
    const size_t voxels = (size_t)nx * ny * nz;
    int32_t stride = sizeof made->voxels[0];
    memset(made, 0, sizeof *made);
    made->voxels = paper_memory(voxels, sizeof made->voxels[0]);
    made->volume.voxels = (qv_address)made->voxels;
    made->volume.voxels_bytes = voxels * sizeof made->voxels[0];
    made->volume.storage = QV_STORAGE_RGBA16;
    for (int axis = 0; axis < 3; axis++) {
        made->volume.size[axis] = (uint16_t)size[axis];
        made->volume.stride[axis] = stride;
        stride *= (int32_t)size[axis];
    }
}

void paper_volume_free(paper_volume *made)
{
    free(made->voxels);
    made->voxels = NULL;
}

void paper_hold_extinction(paper_volume *made, double tau)
{
    made->volume.storage = QV_STORAGE_RGBT16;
    made->volume.extinction = q16(tau / log(2));
}

double paper_opacity(double tau, double length)
{
    return 1 - exp(-tau * length);
}

uint16_t *paper_voxel(const paper_volume *of, unsigned x, unsigned y, unsigned z)
{
    const uint16_t *size = of->volume.size;
    return of->voxels[x + size[0] * (y + (size_t)size[1] * z)];
}

void paper_volume_fill(const paper_volume *made, paper_fill *fill, const void *from)
{
    const uint16_t *size = made->volume.size;
    unsigned at[3];
    for (at[2] = 0; at[2] < size[2]; at[2]++) {
        for (at[1] = 0; at[1] < size[1]; at[1]++) {
            for (at[0] = 0; at[0] < size[0]; at[0]++) {
                fill(paper_voxel(made, at[0], at[1], at[2]), at, from);
            }
        }
    }
}

#define HEAD_FILE  "/usr/share/mricron/templates/ch2.nii.gz"
#define HEAD_BEGIN 352 /* bytes before the voxels of a NIfTI-1 file */

uint8_t *paper_head(void)
{
    const size_t voxels = (size_t)PAPER_HEAD_X * PAPER_HEAD_Y * PAPER_HEAD_Z;
    unsigned char header[HEAD_BEGIN];
    uint8_t *head = paper_memory(voxels, 1);
    FILE *pipe = popen("gzip -dc " HEAD_FILE, "r");
    paper_require(pipe != NULL && fread(header, 1, sizeof header, pipe) == sizeof header &&
                      fread(head, 1, voxels, pipe) == voxels,
                  "cannot read " HEAD_FILE " (Debian's mricron-data)");
    (void)pclose(pipe);
    return head;
}

void paper_pyramid_make(paper_pyramid *made, const qv_volume *volume, const qv_filter *filter,
                        const qv_domain *domain, uint8_t levels)
{
    made->pyramid.levels = levels;
    made->pyramid.bytes = qv_pyramid_bytes(volume->size, volume->storage, levels);
    made->voxels = paper_memory((size_t)made->pyramid.bytes, 1);
    made->pyramid.voxels = made->voxels;
    for (uint8_t number = 0; number < levels; number++) {
        qv_volume finer, coarser;
        paper_require(qv_pyramid_level(&finer, volume, &made->pyramid, number) == QV_OK &&
                          qv_pyramid_level(&coarser, volume, &made->pyramid, number + 1u) == QV_OK,
                      "cannot describe a level");
        uint8_t *voxels = made->voxels + (coarser.voxels - made->pyramid.voxels);
        paper_require(qv_downsample(voxels, (size_t)coarser.voxels_bytes, &finer, filter, domain, 0,
                                    coarser.size[2]) == QV_OK,
                      "cannot downsample");
    }
}

void paper_pyramid_free(paper_pyramid *made)
{
    free(made->voxels);
    made->voxels = NULL;
}

/* ---- Views ---------------------------------------------------------------- */

static qv_angle binary_angle(double degrees)
{
    return (qv_angle)(int64_t)floor(degrees / 360 * 4294967296.0 + 0.5);
}

void paper_frame(qv_view *frame, const paper_view *view)
{
    qv_rotation(frame->rotation, binary_angle(view->azimuth), binary_angle(view->elevation), 0);
    frame->pitch = q16(view->pitch);
    frame->step = q16(view->step);
    frame->width = view->width;
    frame->height = view->height;
}

void paper_look(qv_scene *scene, const paper_view *view)
{
    qv_view frame;
    paper_frame(&frame, view);
    paper_require(qv_orthographic(&scene->camera, &scene->volume, &frame) == QV_OK, "camera");
}

void paper_look_along_z(qv_scene *scene, double start, double step)
{
    qv_camera *camera = &scene->camera;
    memset(camera, 0, sizeof *camera);
    camera->projection = &qv_projection_orthographic;
    camera->step = q16(step);
    camera->origin[0] = PAPER_VOXEL / 2;
    camera->origin[1] = PAPER_VOXEL / 2;
    camera->origin[2] = (qv_coord)floor(start * (double)PAPER_VOXEL + 0.5);
    camera->across[0] = PAPER_VOXEL;
    camera->down[1] = PAPER_VOXEL;
    camera->along[2] = (qv_coord)camera->step << 16;
}

/* ---- Files ---------------------------------------------------------------- */

FILE *paper_open(const char *folder, const char *name)
{
    char path[FILENAME_MAX];
    (void)snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "wb");
    paper_require(file != NULL, path);
    return file;
}

void paper_close(FILE *file)
{
    const bool failed = ferror(file) != 0;
    paper_require(fclose(file) == 0 && !failed, "a file could not be written");
}

void paper_table_begin(FILE *table, const char *title)
{
    fprintf(table, "%s\n\n", title);
    fputs("| what | paper | double precision | ours | difference | allowed |\n", table);
    fputs("|---|---|---|---|---|---|\n", table);
}

void paper_table_add(FILE *table, const paper_row *row)
{
    fprintf(table, "| %s | %s | %.6f | %.6f | %.2g | %.2g |\n", row->what, row->paper, row->exact,
            row->ours, row->ours - row->exact, row->allowed);
}
