# The precision report: a program for each section, of a folder of its own and what the papers'
# programs share. precision.sh puts the report together.
PRECISION_SECTIONS := stages pictures
PRECISION_PROGRAMS := $(PRECISION_SECTIONS:%=$(TEST_OUT)/precision/%)
precision_objects = $(patsubst %.c,$(TEST_OUT)/%.o,$(wildcard tests/papers/*.c tests/precision/$(1)/*.c))

.PHONY: precision precision-programs
precision: setup ## the precision report: tests/precision/REPORT.md, CSV and plots in build/precision/
	@$(MAKE) -s --no-print-directory precision-programs
	@BUILD=$(BUILD) tests/precision/precision.sh $(PRECISION_SECTIONS)
	cp $(BUILD)/precision/REPORT.md tests/precision/REPORT.md

precision-programs: $(PRECISION_PROGRAMS)

$(TEST_OUT)/precision/stages: $(call precision_objects,stages)
$(TEST_OUT)/precision/pictures: $(call precision_objects,pictures)

$(PRECISION_PROGRAMS): $(REFERENCE_OBJECTS) $(LIBRARY)
	@mkdir -p $(@D)
	@echo "  LD  $@"
	@$(CC) $(CFLAGS) $(filter %.o,$^) $(LIBRARY) -lm -o $@
