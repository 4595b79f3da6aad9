/*
 * report_splat.c - a picture of splats as JSON.
 */
#include "report_splat.h"
#include "lighting.h"
#include "parallel.h"
#include "report.h"
#include "report_freevoxel.h"
#include "settings_freevoxel.h"

static void report_splatting(struct json *json, const qv_splat_scene *scene,
                             const struct settings *settings)
{
    const struct splat_settings *s = &settings->splat;
    json_object(json, "splatting");
    json_text(json, "how", choice_name(splatting_names, s->splatting));
    json_text(json, "kernel", choice_name(kernel_names, s->kernel));
    json_text(json, "interpolation", choice_name(interpolation_names, scene->interpolation));
    json_integer(json, "finest_level", scene->level);
    json_integer(json, "coarsest_level", scene->coarsest);
    json_integer(json, "detail_q8", scene->detail);
    if (s->parts != 0) {
        json_integer(json, "part", s->part);
        json_integer(json, "parts", s->parts);
    } else {
        json_null(json, "part");
        json_null(json, "parts");
    }
    json_close(json);
}

/* Back to front, all workers share the sums. */
static void report_memory(struct json *json, const struct freevoxel_file *file,
                          const struct frame *frame, const struct settings *settings)
{
    bool shared = settings->splat.splatting == SPLATTING_OVER;
    uint64_t pixels = (uint64_t)frame->width * frame->height;
    uint64_t sums = pixels * QV_SUM_CHANNELS * sizeof(uint32_t);
    json_object(json, "memory");
    json_unsigned(json, "mapped_bytes", file->header.total_bytes);
    json_unsigned(json, "sums_bytes", shared ? sums : sums * parallel_threads(settings->threads));
    json_close(json);
}

void report_splats(struct json *json, const struct freevoxel_file *file, const qv_splats *splats,
                   const struct view *view, const struct frame *frame, uint64_t drawn,
                   const struct settings *settings)
{
    const qv_splat_scene *scene = &splats->scene;
    report_freevoxel_file(json, file);
    report_view(json, view);
    report_splatting(json, scene, settings);
    report_lighting(json, &scene->lighting);
    report_frame(json, scene->background, frame);
    report_memory(json, file, frame, settings);
    json_object(json, "statistics");
    json_unsigned(json, "voxels_with_opacity", drawn);
    json_decimal(json, "seconds", frame->seconds);
    json_close(json);
}
