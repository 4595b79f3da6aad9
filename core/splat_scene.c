#include "bearing.h"
#include "camera.h"
#include "direction.h"
#include "eye.h"
#include "kernel.h"
#include "layout.h"
#include "lighting.h"
#include "order.h"
#include "palette.h"
#include "splat.h"
#include "storage.h"
#include "thickness.h"

#define ONE_Q30 ((uint32_t)1 << 30)

/* Rows of a rotation are this near to length 1, Q2.30. */
#define ROW_TOLERANCE ((uint32_t)1 << 20)

/* Light of a voxel that covers a pixel alone and is opaque, Q10.22: 255 levels. */
#define WHITE ((uint32_t)255 << 22)

/* ---- Checks ----------------------------------------------------------------- */

static qv_status check_volume(const qv_volume *volume, const qv_domain *domain)
{
    unsigned storage = volume->storage;
    if (storage - QV_STORAGE_RGBA8 > QV_STORAGE_INDEXED8_T16 - QV_STORAGE_RGBA8)
        return QV_ERROR_STORAGE;
    if (QV_FIELD(domain, of_opacity) == qv_storage_extinction(storage))
        return QV_ERROR_STORAGE;
    if (!qv_box_valid(volume->size))
        return QV_ERROR_SIZE;
    qv_status status =
        qv_palette_check(volume, qv_channel_bytes(storage), qv_storage_indexed(storage));
    return status == QV_OK ? qv_spacing_check(volume->spacing) : status;
}

/* Each row of the rotation has a length of about 1; |row| <= 2^31. */
static FX_NOINLINE int is_rotation(const int32_t rotation[3][3])
{
    for (unsigned row = 0; row < 3; row++) {
        uint32_t v[3];
        for (unsigned axis = 0; axis < 3; axis++)
            v[axis] = fx_magnitude(rotation[row][axis]);
        uint32_t length = qv_length_of(v);
        if (length < ONE_Q30 - ROW_TOLERANCE || length > ONE_Q30 + ROW_TOLERANCE)
            return 0;
    }
    return 1;
}

static qv_status check_view(const qv_splat_scene *scene)
{
    qv_status status = qv_frame_check(&scene->volume, &scene->view);
    if (status == QV_OK && !is_rotation(scene->view.rotation))
        status = QV_ERROR_VIEW;
    return status;
}

static FX_NOINLINE qv_status check(const qv_splat_scene *scene)
{
    if (!scene->splatting || !scene->kernel || !scene->domain)
        return QV_ERROR_NULL;
    qv_status status = check_volume(&scene->volume, scene->domain);
    if (status == QV_OK)
        status = check_view(scene);
    if (status == QV_OK)
        status = qv_lighting_check(&scene->lighting);
    if (status != QV_OK)
        return status;
    if (scene->level > scene->coarsest || scene->coarsest > qv_pyramid_levels(scene->volume.size))
        return QV_ERROR_LEVEL;
    return qv_directions_known(scene->directions) && scene->interpolation <= QV_BETWEEN_DEPTHS
               ? QV_OK
               : QV_ERROR_DIRECTION;
}

/* ---- Geometry --------------------------------------------------------------- */

/* Half a voxel along a row of the rotation, in pixels of the plane through the centre, Q31.32:
   row * spacing / (2 pitch), where row * spacing * 2 < 2^56. */
static int64_t half_in_pixels(int32_t row, uint32_t spacing, uint32_t pitch)
{
    uint64_t size = fx_wide_product(fx_magnitude(row), spacing) << 1;
    int64_t pixels = (int64_t)fx_divide(size + pitch / 2u, pitch);
    return row < 0 ? -pixels : pixels;
}

/* Width of a voxel across a row of the rotation: the root of the sum of squares of its sides as
   they show there. World units. */
static fx_scaled width_across(const int32_t row[3], const uint32_t spacing[3])
{
    uint32_t v[3];
    for (unsigned axis = 0; axis < 3; axis++) /* Q30 * Q16 to Q23, at most 2^31 + 2^21 */
        v[axis] =
            (uint32_t)(fx_wide_product(fx_magnitude(row[axis]), qv_spacing(spacing, axis)) >> 23);
    return fx_scaled_of(qv_length_of(v), -23);
}

static fx_scaled voxel_volume(const uint32_t spacing[3])
{
    fx_scaled product = fx_scaled_of(1, 0);
    for (unsigned axis = 0; axis < 3; axis++)
        product = fx_scaled_times(product, fx_scaled_of(qv_spacing(spacing, axis), -16));
    return product;
}

static FX_NOINLINE qv_status set_geometry(qv_splats *splats)
{
    const qv_view *view = &splats->scene.view;
    const uint32_t *spacing = splats->scene.volume.spacing;
    const fx_scaled pitch = fx_scaled_of(view->pitch, -16);
    const fx_scaled least = fx_scaled_of(QV_LEAST_WIDTH, -16);
    const fx_scaled most = fx_scaled_of(QV_MOST_WIDTH, -16);
    fx_scaled area = voxel_volume(spacing);
    for (unsigned i = 0; i < 2; i++) {
        fx_scaled width = width_across(view->rotation[i], spacing);
        area = fx_scaled_over(area, width);
        width = fx_scaled_over(width, pitch);
        qv_splats_set(splats, QV_WIDTH + i, width);
        width = qv_scaled_up(width, splats->scene.level);
        if (!fx_scaled_at_most(least, width) || !fx_scaled_at_most(width, most))
            return QV_ERROR_VIEW;
    }
    qv_splats_set(splats, QV_GAIN, fx_scaled_times(area, fx_scaled_of(WHITE, 0)));
    for (unsigned axis = 0; axis < 3; axis++) {
        uint32_t side = qv_spacing(spacing, axis);
        splats->across[axis] = half_in_pixels(view->rotation[0][axis], side, view->pitch);
        splats->down[axis] = half_in_pixels(view->rotation[1][axis], side, view->pitch);
        /* world units, Q31.32: row * spacing / 2 */
        splats->ahead[axis] = fx_scale_q30((int64_t)side << 15, view->rotation[2][axis]);
    }
    return QV_OK;
}

/* ---- Viewer ----------------------------------------------------------------- */

/* Half voxels from the centre of the box to the eye, Q47.16: below 2^45. */
static FX_NOINLINE void eye_of(int64_t eye[3], const qv_splat_scene *scene, qv_coord distance)
{
    int64_t world[3];
    for (unsigned axis = 0; axis < 3; axis++) /* twice the way */
        world[axis] = -fx_scale_q30(distance, scene->view.rotation[2][axis]) * 2;
    qv_bearing_voxels(eye, world, scene->volume.spacing);
}

int qv_splat_eye(uint16_t position[3], const qv_splat_scene *scene)
{
    qv_coord distance;
    int64_t eye[3];
    if (!position || !scene || scene->field_of_view == 0 || check_view(scene) != QV_OK ||
        qv_eye_of(&distance, &scene->view, scene->field_of_view) != QV_OK)
        return 0;
    eye_of(eye, scene, distance);
    for (unsigned axis = 0; axis < 3; axis++) {
        int64_t half = scene->volume.size[axis];
        eye[axis] += half << 16; /* half voxels from the box's corner */
        if (eye[axis] < 0 || eye[axis] >= half << 17)
            return 0;
    }
    for (unsigned axis = 0; axis < 3; axis++)
        position[axis] = (uint16_t)(eye[axis] >> 17);
    return 1;
}

/* An orthographic viewer is in the same direction for all voxels. */
static FX_NOINLINE qv_status set_orthographic(qv_splats *splats)
{
    qv_splat_scene *scene = &splats->scene;
    scene->inside = 0; /* there is no eye that could be in the volume */
    int64_t world[3], v[3];
    int32_t scaled[3];
    for (unsigned axis = 0; axis < 3; axis++) /* Q.56, which voxels turn into Q.40 */
        world[axis] = -(int64_t)scene->view.rotation[2][axis] * ((int64_t)1 << 26);
    qv_bearing_voxels(v, world, scene->volume.spacing);
    int halved = qv_bearing_scale(scaled, v);
    fx_scaled layers = fx_scaled_of(qv_bearing_largest(scaled), halved - 40);
    fx_scaled gain = fx_scaled_times(qv_splats_number(splats, QV_GAIN), layers);
    splats->gain = fx_scaled_fixed(gain, 0, 0xFFFFFFFFu);
    for (unsigned i = 0; i < 2; i++) {
        fx_scaled width = qv_scaled_up(qv_splats_number(splats, QV_WIDTH + i), scene->level);
        splats->size[i] = fx_scaled_fixed(width, 16, QV_MOST_WIDTH);
    }
    splats->drawn = scene->level;
    for (unsigned level = scene->level + 1u; level <= scene->coarsest; level++)
        if (qv_splats_fine(splats, fx_scaled_of(1, 0), level))
            splats->drawn = (uint8_t)level;
    return qv_bearing_of(&splats->viewer, &splats->length, &splats->compass, scaled);
}

/* From a corner of what an eye sees, the way to the eye; 0 where that is no way at all. Voxels
   whose centres lie beyond are not drawn. */
static FX_NOINLINE int corner_of(int32_t scaled[3], const qv_splats *splats, qv_coord distance,
                                 unsigned corner)
{
    const qv_splat_scene *scene = &splats->scene;
    const qv_view *view = &scene->view; /* its pitch and the reach are Q16.16: below 2^56 */
    int64_t width = (int64_t)fx_wide_product(view->pitch, qv_splats_reach(splats, 0));
    int64_t height = (int64_t)fx_wide_product(view->pitch, qv_splats_reach(splats, 1));
    int64_t world[3], v[3];
    for (unsigned axis = 0; axis < 3; axis++) {
        int64_t right = fx_scale_q30(width, view->rotation[0][axis]);
        int64_t down = fx_scale_q30(height, view->rotation[1][axis]);
        world[axis] = -fx_scale_q30(distance, view->rotation[2][axis]);
        world[axis] += (corner & 1u) != 0 ? right : -right;
        world[axis] += (corner & 2u) != 0 ? down : -down;
    }
    qv_bearing_voxels(v, world, scene->volume.spacing);
    if (!qv_bearing_leads(v))
        return 0;
    (void)qv_bearing_scale(scaled, v);
    return 1;
}

/* Light must be known from all directions by which it may come, and be seen where the eye is. */
static FX_NOINLINE qv_status check_reach(const qv_splats *splats, qv_coord distance)
{
    const qv_splat_scene *scene = &splats->scene;
    int32_t corner[4][3];
    qv_bearing bearing;
    uint32_t length;
    for (unsigned i = 0; i < 4; i++) {
        if (!corner_of(corner[i], splats, distance, i))
            return QV_ERROR_VIEW;
        if (scene->interpolation == QV_NEAREST &&
            qv_bearing_of(&bearing, &length, &splats->compass, corner[i]) != QV_OK)
            return QV_ERROR_DIRECTION;
    }
    uint32_t reach = scene->interpolation == QV_NEAREST
                         ? qv_bearing_facing(&splats->compass, corner)
                         : qv_bearing_reach(corner);
    if ((reach & ~splats->compass.directions) != 0)
        return QV_ERROR_DIRECTION;
    for (uint8_t direction = 0; scene->inside && direction < QV_DIRECTIONS; direction++) {
        uint8_t slot = qv_direction_slot(scene->directions, direction);
        if ((reach >> direction & 1u) != 0 && qv_read8(qv_at(scene->inside, slot)) == 0)
            return QV_ERROR_INSIDE;
    }
    return QV_OK;
}

static FX_NOINLINE qv_status set_perspective(qv_splats *splats)
{
    uint16_t position[3];
    qv_coord distance;
    qv_splat_scene *scene = &splats->scene;
    qv_status status = qv_eye_of(&distance, &scene->view, scene->field_of_view);
    if (status != QV_OK)
        return status;
    eye_of(splats->eye, scene, distance);
    qv_splats_set(splats, QV_DISTANCE, fx_scaled_of((uint64_t)distance, -32));
    splats->distance = distance;
    if (!QV_FIELD(scene->splatting, attenuated) || !qv_splat_eye(position, scene))
        scene->inside = 0;
    else if (!scene->inside)
        return QV_ERROR_NULL;
    return check_reach(splats, distance);
}

/* Where no byte towards the viewer is read, all count as there. */
static FX_NOINLINE qv_status set_light(qv_splats *splats)
{
    const qv_splat_scene *scene = &splats->scene;
    qv_thickness thickness;
    uint32_t longest = qv_direction_length(scene->volume.spacing, QV_DIRECTIONS - 1u);
    qv_status status = qv_thickness_of(&thickness, &scene->volume, longest);
    if (status != QV_OK)
        return status;
    splats->factor = thickness.factor;
    splats->shift = thickness.shift;
    qv_compass_of(&splats->compass, &scene->volume, scene->directions, scene->interpolation);
    status = qv_lighting_bearings(splats->lamp, &scene->lighting, &splats->compass,
                                  scene->volume.spacing);
    if (!QV_FIELD(scene->splatting, attenuated))
        splats->compass.directions = QV_DIRECTIONS_ALL;
    return status;
}

qv_status qv_splat_init(qv_splats *splats, const qv_splat_scene *scene)
{
    const size_t known = sizeof splats->scene;
    qv_status status = splats && scene ? check(scene) : QV_ERROR_NULL;
    if (status != QV_OK)
        return status;
    splats->scene = *scene;
    memset((uint8_t *)splats + known, 0, sizeof *splats - known);
    status = set_geometry(splats);
    if (status == QV_OK)
        status = set_light(splats);
    if (status == QV_OK)
        status =
            splats->scene.field_of_view == 0 ? set_orthographic(splats) : set_perspective(splats);
    if (status != QV_OK)
        memset(splats, 0, sizeof *splats);
    return status;
}
