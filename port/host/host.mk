# The command qvol: its sources, and the libraries that add formats to it.
#
# A library is used where a program that includes and links it compiles, unless
# it is named in WITHOUT ("png nifti nrrd").
#
#   HOST_SOURCES, HOST_CPPFLAGS, HOST_LIBS   to compile and link the command
#   HOST_PACKAGES_FOUND                      of png, nifti and nrrd
#   host-flags                               a target that prints the first three

HOST_DIR := port/host
HOST_NIFTI_INCLUDE ?= /usr/include/nifti

# $(call host_try,name,header,flags): name, if it compiles.
host_try = $(if $(filter $(1),$(WITHOUT)),,$(shell \
	echo 'int main(void) { return 0; }' | \
	$(CC) $(CFLAGS) -include stdio.h -include $(2) -x c - -o /dev/null $(3) 2>/dev/null && echo $(1)))

HOST_PNG_LIBS := -lpng
HOST_NIFTI_CPPFLAGS := -isystem $(HOST_NIFTI_INCLUDE)
HOST_NIFTI_LIBS := -lnifti2 -lznz
HOST_NRRD_LIBS := -lteem

HOST_PACKAGES_FOUND := $(strip \
	$(call host_try,png,png.h,$(HOST_PNG_LIBS)) \
	$(call host_try,nifti,nifti2_io.h,$(HOST_NIFTI_CPPFLAGS) $(HOST_NIFTI_LIBS)) \
	$(call host_try,nrrd,teem/nrrd.h,$(HOST_NRRD_LIBS)))

HOST_SOURCES := $(sort $(filter-out %/png_file.c %/read_nifti.c %/read_nrrd.c, \
	$(wildcard $(HOST_DIR)/*.c))) port/crc32.c
HOST_CPPFLAGS := -D_FILE_OFFSET_BITS=64 -I$(HOST_DIR) -Iport -Icore
HOST_LIBS := -pthread -lm

ifneq ($(filter png,$(HOST_PACKAGES_FOUND)),)
HOST_SOURCES += $(HOST_DIR)/png_file.c
HOST_CPPFLAGS += -DHAVE_PNG
HOST_LIBS += $(HOST_PNG_LIBS)
endif
ifneq ($(filter nifti,$(HOST_PACKAGES_FOUND)),)
HOST_SOURCES += $(HOST_DIR)/read_nifti.c
HOST_CPPFLAGS += -DHAVE_NIFTI $(HOST_NIFTI_CPPFLAGS)
HOST_LIBS += $(HOST_NIFTI_LIBS)
endif
ifneq ($(filter nrrd,$(HOST_PACKAGES_FOUND)),)
HOST_SOURCES += $(HOST_DIR)/read_nrrd.c
HOST_CPPFLAGS += -DHAVE_NRRD
HOST_LIBS += $(HOST_NRRD_LIBS)
endif

HOST_OBJECTS := $(HOST_SOURCES:%.c=$(OUT)/%.o)
HOST_CFLAGS = -std=c99 $(WARNINGS) -MMD -MP $(OPTIMISE) $(CFLAGS) -pthread $(HOST_CPPFLAGS)

# Which libraries there are is among the options.
HOST_OPTIONS := $(call remember,$(OUT)/host-options,$(CC) $(HOST_CFLAGS) $(LDFLAGS) $(HOST_LIBS))

$(OUT)/port/%.o: port/%.c $(HOST_OPTIONS)
	@mkdir -p $(@D)
	@echo "  CC  $<"
	@$(CC) $(HOST_CFLAGS) -c $< -o $@

# The one file that knows where things are installed.
$(OUT)/port/host/vector_files.o: HOST_CPPFLAGS += -DQVOL_VECTORS='"$(PREFIX)/share/qvol/vectors"'
$(OUT)/port/host/vector_files.o: $(call remember,$(OUT)/prefix,$(PREFIX))

$(QVOL): $(HOST_OBJECTS) $(LIBRARY)
	@echo "  LD  $@"
	@$(CC) $(OPTIMISE) $(CFLAGS) $(LDFLAGS) -o $@ $(HOST_OBJECTS) $(LIBRARY) $(HOST_LIBS)

-include $(HOST_OBJECTS:.o=.d)

.PHONY: host-flags
host-flags:
	@echo $(HOST_CPPFLAGS) $(HOST_SOURCES) $(HOST_LIBS)
