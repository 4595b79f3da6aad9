#include "comparison.h"

typedef uint8_t picture[SEEDED_MOST_EDGE][SEEDED_MOST_EDGE][4];

static qv_status render(picture pixels, const seeded_scene *made)
{
    const qv_rect rect = {0, 0, (int32_t)made->view.width, (int32_t)made->view.height};
    const qv_image image = {pixels, sizeof(picture), sizeof pixels[0], &qv_format_rgba8888};
    qv_context context;
    const qv_status status = qv_init(&context, &made->scene);
    return status == QV_OK ? qv_render(&image, &context, &rect) : status;
}

static void tally_picture(tally *into, picture pixels, const seeded_scene *made, ref_mode mode,
                          ref_camera camera)
{
    ref_pixel expected;
    for (int32_t y = 0; y < made->view.height; y++) {
        for (int32_t x = 0; x < made->view.width; x++) {
            if (camera == REF_IDEAL_CAMERA) {
                ref_render_ideal(&expected, &made->scene, &made->view, mode, x, y);
            } else {
                ref_render(&expected, &made->scene, mode, x, y);
            }
            if (expected.opacity > 0) {
                tally_pixel(into, pixels[y][x], &expected);
            }
        }
    }
}

qv_status compare_scenes(tally *into, const seeded_scene *made, const seeded_scene *expected,
                         ref_mode mode, ref_camera camera)
{
    static picture pixels;
    const qv_status status = render(pixels, made);
    if (status == QV_OK) {
        tally_picture(into, pixels, expected, mode, camera);
    }
    return status;
}

qv_status compare_scene(tally *into, const seeded_scene *made, ref_mode mode, ref_camera camera)
{
    return compare_scenes(into, made, made, mode, camera);
}
