/*
 * read_nifti.c - NIfTI-1 and NIfTI-2, plain or gzip, through nifticlib.
 *
 * The header is read and checked here before the library turns it into an
 * image description: it trusts sizes, offsets and counts. Extensions are passed
 * over by the header's own offset.
 */
#define _POSIX_C_SOURCE 200809L

#include "input.h"
#include "error.h"
#include "quiet.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include <nifti2_io.h>
#include <znzlib.h>

/* deflate makes at most 1032 bytes of one, plus a block's header. */
#define DEFLATE_RATIO 1032u
/* Offsets above are no place for data: extensions are small. */
#define OFFSET_MOST (1 << 30)

union header {
    int32_t size; /* 348 or 540, swapped in a file of the other byte order */
    nifti_1_header one;
    nifti_2_header two;
};

/* What the library would quietly mend or trust. */
struct geometry {
    int64_t dim[8];
    double pixdim[8];
    double offset;
    int datatype;
    int bits;
};

/* The types that have a meaning as one scalar. */
static element element_of(int datatype)
{
    switch (datatype) {
    case DT_UINT8:
        return ELEMENT_U8;
    case DT_INT8:
        return ELEMENT_S8;
    case DT_UINT16:
        return ELEMENT_U16;
    case DT_INT16:
        return ELEMENT_S16;
    case DT_UINT32:
        return ELEMENT_U32;
    case DT_INT32:
        return ELEMENT_S32;
    case DT_FLOAT32:
        return ELEMENT_F32;
    case DT_FLOAT64:
        return ELEMENT_F64;
    default:
        return ELEMENT_NONE;
    }
}

/* gzip is known by its mark, not by the name. */
static znzFile open_file(const struct source *source)
{
    unsigned char mark[2] = {0, 0};
    znzFile file;
    source_peek(source, mark, sizeof mark);
    file = znzopen(source->path, "rb", mark[0] == 0x1f && mark[1] == 0x8b);
    if (znz_isnull(file)) {
        system_error(source->name, NULL);
    }
    return file;
}

/* Part of the header, or an error. */
static void need_bytes(const struct source *source, znzFile file, void *bytes, size_t count)
{
    if (znzread(bytes, 1, count, file) != count) {
        data_error(source->name, "header", "damaged, or the file ends inside it");
    }
}

/* Reads the header into the machine's byte order; returns whether it was in the
   other one. */
static bool read_header(const struct source *source, znzFile file, union header *header)
{
    bool swapped;
    int32_t size;
    need_bytes(source, file, header, sizeof header->size);
    size = header->size;
    swapped = size != 348 && size != 540;
    if (swapped) {
        swap_words(&size, sizeof size, sizeof size);
    }
    if (size != 348 && size != 540) {
        data_error(source->name, "sizeof_hdr", "neither NIfTI-1 (348) nor NIfTI-2 (540)");
    }
    need_bytes(source, file, (unsigned char *)header + sizeof size, (size_t)size - sizeof size);
    if (swapped && size == 348) {
        nifti_swap_as_nifti1(&header->one);
    } else if (swapped) {
        nifti_swap_as_nifti2(&header->two);
    }
    header->size = size;
    return swapped;
}

/* "n+1" and "n+2" are single files; "ni1" and "ni2" pairs. */
static void check_magic(const struct source *source, const union header *header)
{
    bool first = header->size == 348;
    const char *magic = first ? header->one.magic : header->two.magic;
    if (memcmp(magic, first ? "ni1" : "ni2", 4) == 0) {
        data_error(source->name, "magic", "header and data in two files: join them into one .nii");
    }
    if (memcmp(magic, first ? "n+1" : "n+2", 4) != 0) {
        data_error(source->name, "magic", "not a NIfTI file");
    }
}

/* The two versions differ in widths and places. */
static void get_geometry(struct geometry *geometry, const union header *header)
{
    bool first = header->size == 348;
    for (unsigned i = 0; i < 8; i++) {
        geometry->dim[i] = first ? header->one.dim[i] : header->two.dim[i];
        geometry->pixdim[i] = first ? (double)header->one.pixdim[i] : header->two.pixdim[i];
    }
    geometry->offset = first ? (double)header->one.vox_offset : (double)header->two.vox_offset;
    geometry->datatype = first ? header->one.datatype : header->two.datatype;
    geometry->bits = first ? header->one.bitpix : header->two.bitpix;
}

/* Dimensions beyond dim[0] have no meaning; those beyond the third must be 1. */
static void check_dimensions(const struct source *source, const int64_t dim[8])
{
    if (dim[0] < 1 || dim[0] > 7) {
        data_error(source->name, "dim[0]", "%lld is no number of dimensions", (long long)dim[0]);
    }
    for (int i = 1; i <= dim[0]; i++) {
        char field[] = "dim[.]";
        field[4] = (char)('0' + i);
        if (dim[i] < 1 || dim[i] > QV_AXIS_MAX) {
            data_error(source->name, field, "%lld voxels, the limits are 1 and %d",
                       (long long)dim[i], QV_AXIS_MAX);
        }
        if (i > 3 && dim[i] > 1) {
            data_error(source->name, field, "%lld volumes in one file, one is needed",
                       (long long)dim[i]);
        }
    }
}

/* The library would mend these to 1. */
static void check_spacing(const struct source *source, const struct geometry *geometry)
{
    for (int i = 1; i <= 3 && i <= geometry->dim[0]; i++) {
        char field[] = "pixdim[.]";
        field[7] = (char)('0' + i);
        if (!isfinite(geometry->pixdim[i]) || geometry->pixdim[i] <= 0) {
            data_error(source->name, field, "%g is not a length", geometry->pixdim[i]);
        }
    }
}

/* Every field that decides how much is read, and from where. */
static void check_geometry(const struct source *source, const union header *header,
                           const struct geometry *geometry)
{
    unsigned bytes = element_bytes(element_of(geometry->datatype));
    check_dimensions(source, geometry->dim);
    check_spacing(source, geometry);
    if (element_of(geometry->datatype) == ELEMENT_NONE) {
        data_error(source->name, "datatype", "code %d (colour, complex or 64-bit) cannot be read",
                   geometry->datatype);
    }
    if (geometry->bits != (int)(8 * bytes)) {
        data_error(source->name, "bitpix", "%d bits do not fit datatype %d", geometry->bits,
                   geometry->datatype);
    }
    if (!(geometry->offset >= header->size && geometry->offset <= OFFSET_MOST)) {
        data_error(source->name, "vox_offset", "%g is no place for the data", geometry->offset);
    }
}

/* The library's form of the header; its messages stay unseen. */
static nifti_image *convert(const struct source *source, const union header *header)
{
    int saved = quiet_begin();
    nifti_image *image;
    nifti_set_debug_level(0);
    image = header->size == 348 ? nifti_convert_n1hdr2nim(header->one, NULL)
                                : nifti_convert_n2hdr2nim(header->two, NULL);
    quiet_end(saved);
    if (image == NULL) {
        data_error(source->name, "header", "refused by nifticlib");
    }
    return image;
}

/* sform before qform, as the standard advises; without either the axes lead
   right, anterior and superior by the voxel sizes. */
static void set_orientation(struct scan *scan, const nifti_image *image)
{
    const nifti_dmat44 *matrix = image->sform_code > 0 ? &image->sto_xyz : &image->qto_xyz;
    bool given = image->sform_code > 0 || image->qform_code > 0;
    double direction[3][3];
    for (unsigned w = 0; w < 3; w++) {
        for (unsigned a = 0; a < 3; a++) {
            direction[w][a] = matrix->m[w][a];
        }
        scan->spacing[w] = image->ndim > w ? image->pixdim[w + 1] : 1;
    }
    if (given && !scan_orient(scan, direction)) {
        data_error(scan->file, image->sform_code > 0 ? "sform" : "qform",
                   "the matrix has no inverse");
    }
}

/* A slope of 0 means that values are not scaled; so does one that is not a number
   (nibabel writes that), which the library turns into 0. */
static void set_scaling(struct scan *scan, const nifti_image *image)
{
    if (image->scl_slope < 0 || image->scl_slope > 0) {
        scan->slope = image->scl_slope;
        scan->offset = image->scl_inter;
    }
}

/* Exactly the bytes that the header implies: neither fewer nor more. */
static void read_values(struct scan *scan, const struct source *source, znzFile file, double offset)
{
    unsigned char more;
    if (znzseek(file, (znz_off_t)offset, SEEK_SET) < 0 ||
        znzread(scan->values, 1, scan->bytes, file) != scan->bytes) {
        data_error(source->name, "data", "damaged, or fewer than the %llu bytes of the header",
                   (unsigned long long)scan->bytes);
    }
    if (znzread(&more, 1, 1, file) != 0) {
        data_error(source->name, "data", "more than the %llu bytes of the header",
                   (unsigned long long)scan->bytes);
    }
}

void read_nifti(struct scan *scan, const struct source *source)
{
    union header header;
    struct geometry geometry;
    nifti_image *image;
    znzFile file = open_file(source);
    bool swapped = read_header(source, file, &header);
    check_magic(source, &header);
    get_geometry(&geometry, &header);
    check_geometry(source, &header, &geometry);
    scan_clear(scan, source->name, header.size == 348 ? "NIfTI-1" : "NIfTI-2");
    scan->type = element_of(geometry.datatype);
    for (unsigned a = 0; a < 3; a++) {
        scan->size[a] = geometry.dim[0] > a ? (uint32_t)geometry.dim[a + 1] : 1;
    }
    image = convert(source, &header);
    set_orientation(scan, image);
    set_scaling(scan, image);
    nifti_image_free(image);
    scan_allocate(scan, file->withz ? source->bytes * DEFLATE_RATIO : source->bytes);
    read_values(scan, source, file, geometry.offset);
    znzclose(file);
    if (swapped && element_word_bytes(scan->type) > 1) {
        swap_words(scan->values, scan->bytes, element_word_bytes(scan->type));
    }
}
