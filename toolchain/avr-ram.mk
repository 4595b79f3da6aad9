# ATmega1284P, 8 bits: volumes lie in RAM, as the golden scenes make them; descriptors do
# not. Functions share their beginnings and ends, so that more scenes fit a program.
TARGET_OPTIONS := -include descriptor_flash.h -mcall-prologues
include toolchain/shared/avr.mk

DIRECT_OR_INDEXED := direct8 direct16 indexed8 indexed16
TARGET_GOLDEN := steps $(DIRECT_OR_INDEXED:%=lengths.%) $(DIRECT_OR_INDEXED:%=bsplines.%) \
	$(DIRECT_OR_INDEXED:%=slices.%) splats.narrow splats.wide preweighted

# Two ways to draw each scene, which take some minutes: whole, and in strips.
TARGET_PORT_CFLAGS += -DGOLDEN_DEVICE_WAYS=2
