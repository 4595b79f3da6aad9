# A head that turns on the panel of a board. toolchain/shared/device.mk includes this file for
# targets that set
#     TARGET_PANEL     the panel's driver in TARGET_PORT_FOLDER, and its header
#     PANEL_OPTIONS    size and format of its pictures, as options of qvol
#     HEAD_STORAGE     of the voxels in flash
#     HEAD_AZIMUTH     of the first frame, whole degrees
# It offers
#     $(OUT)/frameN.json    what the host rendered for frame N, with its checksum, and
#     $(OUT)/frameN.png     the picture as the panel is to show it
# Variables:
#     SCAN             the scan to show
#     SCAN_OPTIONS     how qvol classifies it
#     PANEL_VIEW       how qvol looks at it

SCAN ?= /usr/share/mricron/templates/ch2.nii.gz
HEAD_FRAMES := 8
FRAME_DEGREES := 45

# Its own rules, in host.mk, decide what has to be done.
$(QVOL): $(LIBRARY_SOURCES) $(wildcard core/*.h fixedpoint/*.h port/*.[ch] port/host/*)
	@$(MAKE) --no-print-directory TARGET=host $@

$(SCAN):
	@echo "make: there is no scan $@; it comes with the package mricron-data, or give SCAN=FILE" >&2; exit 2

HEAD_OPTIONS := $(call remember,$(OUT)/head-options,$(SCAN) $(HEAD_STORAGE) $(SCAN_OPTIONS))
VIEW_OPTIONS := $(call remember,$(OUT)/view-options,$(HEAD_AZIMUTH) $(PANEL_OPTIONS) $(PANEL_VIEW))
classify_head = $(QVOL) classify $(SCAN) --quiet --storage $(HEAD_STORAGE) $(SCAN_OPTIONS)

$(OUT)/head.c: $(SCAN) $(QVOL) $(HEAD_OPTIONS)
	@mkdir -p $(@D)
	@echo "  GEN $@"
	@$(classify_head) --name head -o $@

# The same voxels for the host, which learns their size from the C file's comment.
$(OUT)/head.raw: $(SCAN) $(QVOL) $(HEAD_OPTIONS)
	@mkdir -p $(@D)
	@echo "  GEN $@"
	@$(classify_head) -o $@

HEAD_SIZE = $$(sed -n -e 's/ x /x/g' -e 's/^ \* size *\([0-9x]*\) voxels/--dims \1/p' \
	-e 's/^ \* spacing *\([0-9.x]*\)/--spacing \1/p' $(OUT)/head.c)
HEAD_PALETTE = $(if $(filter indexed8,$(HEAD_STORAGE)),--palette $(OUT)/head.raw.palette)

# The report of a frame holds its view and its checksum.
$(OUT)/frame%.json: $(OUT)/head.raw $(OUT)/head.c $(VIEW_OPTIONS)
	@echo "  GEN $@"
	@$(QVOL) render $< --quiet --type $(HEAD_STORAGE) $(HEAD_PALETTE) $(HEAD_SIZE) $(PANEL_OPTIONS) \
		--azimuth $$(($(HEAD_AZIMUTH) + $(FRAME_DEGREES) * $*)) $(PANEL_VIEW) \
		--json=$@ -o $(@:.json=.png)

$(OUT)/head_view.h: $(OUT)/frame0.json
	@echo "  GEN $@"
	@toolchain/view_header $< >$@

$(OUT)/port/firmware_head.o: $(OUT)/head_view.h
$(OUT)/port/firmware_head.o: TARGET_PORT_CFLAGS += \
	-DHEAD_FRAMES=$(HEAD_FRAMES)u -DHEAD_SAMPLING=qv_weighted_$(HEAD_STORAGE)
$(addprefix $(OUT)/port/,firmware_head.o firmware_picture.o panel_show.o): \
	TARGET_PORT_CFLAGS += -DPANEL_HEADER='"$(TARGET_PANEL).h"'
