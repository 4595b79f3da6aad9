# The command qvol-mpi: the splatting of qvol on the ranks of an mpirun.
#
# It is built with the rest where a program that includes and links Open MPI compiles,
# unless WITHOUT names mpi. The compiler is that of the rest: mpicc only tells what MPI needs.

MPI_DIR := port/mpi
MPICC ?= mpicc
QVOL_MPI := $(BUILD)/host/qvol-mpi

ifneq ($(shell command -v $(MPICC)),)
MPI_CPPFLAGS := $(patsubst -I%,-isystem %,$(shell $(MPICC) --showme:compile 2>/dev/null))
MPI_LIBS := $(shell $(MPICC) --showme:link 2>/dev/null)
MPI_FOUND := $(call host_try,mpi,mpi.h,$(MPI_CPPFLAGS) $(MPI_LIBS))
endif

# Its own main, and all of qvol but qvol's.
MPI_OWN_OBJECTS := $(patsubst %.c,$(OUT)/%.o,$(sort $(wildcard $(MPI_DIR)/*.c)))
MPI_OBJECTS := $(MPI_OWN_OBJECTS) $(filter-out %/host/main.o,$(HOST_OBJECTS))
MPI_OPTIONS := $(call remember,$(OUT)/mpi-options,$(MPI_CPPFLAGS) $(MPI_LIBS))

# What is built and installed beside qvol.
MPI_COMMAND := $(if $(MPI_FOUND),$(QVOL_MPI))

.PHONY: mpi
all: $(MPI_COMMAND)

ifneq ($(MPI_COMMAND),)
mpi: $(QVOL_MPI) ## qvol-mpi for clusters; needs Open MPI
else
mpi:
	@echo "make: qvol-mpi needs Open MPI; Debian's packages: libopenmpi-dev openmpi-bin" >&2; exit 2
endif

$(MPI_OWN_OBJECTS): HOST_CPPFLAGS += $(MPI_CPPFLAGS)
$(MPI_OWN_OBJECTS): $(MPI_OPTIONS)

$(QVOL_MPI): $(MPI_OBJECTS) $(LIBRARY)
	@echo "  LD  $@"
	@$(CC) $(OPTIMISE) $(CFLAGS) $(LDFLAGS) -o $@ $(MPI_OBJECTS) $(LIBRARY) $(HOST_LIBS) $(MPI_LIBS)

-include $(MPI_OWN_OBJECTS:.o=.d)
