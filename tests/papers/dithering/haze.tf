# Figure 3: what surrounds the brain as a haze. 0.0037 for a voxel is 2.3 / 255 for each of
# 128 slices, but 0.49 / 255 for each of 600: less than 8 bits can hold.
0    255 222 120   0
16   255 222 120   0
24   255 222 120   0.0037
255  255 222 120   0.0037
shading 0.95 0.3 0 1 0.01
