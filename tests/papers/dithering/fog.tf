# Figure 6: the whole box full of white fog, 1.2 / 255 for each of 400 slices.
0    255 255 255   0.006
255  255 255 255   0.006
shading 1 0 0 1 1
