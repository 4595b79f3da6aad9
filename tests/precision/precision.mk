# The precision report: a program for each section, of a folder of its own and what the papers'
# programs share, or a script, section.sh. precision.sh puts the report together.
PRECISION_SECTIONS := stages pictures meaning claims
PRECISION_SCRIPTS := $(notdir $(patsubst %/section.sh,%,$(wildcard tests/precision/*/section.sh)))
PRECISION_PROGRAMS := \
	$(patsubst %,$(TEST_OUT)/precision/%,$(filter-out $(PRECISION_SCRIPTS),$(PRECISION_SECTIONS)))
precision_objects = $(patsubst %.c,$(TEST_OUT)/%.o,$(wildcard tests/papers/*.c tests/precision/$(1)/*.c))

.PHONY: precision precision-programs
precision: setup ## the precision report: tests/precision/REPORT.md, CSV and plots in build/precision/
	@$(MAKE) -s --no-print-directory precision-programs
	@BUILD=$(BUILD) tests/precision/precision.sh $(PRECISION_SECTIONS)
	cp $(BUILD)/precision/REPORT.md tests/precision/REPORT.md

precision-programs: $(PRECISION_PROGRAMS) $(PAPER_PROGRAMS) $(QVOL)

$(TEST_OUT)/precision/stages: $(call precision_objects,stages)
$(TEST_OUT)/precision/pictures: $(call precision_objects,pictures)

$(PRECISION_PROGRAMS): $(REFERENCE_OBJECTS) $(LIBRARY)
	@mkdir -p $(@D)
	@echo "  LD  $@"
	@$(CC) $(CFLAGS) $(filter %.o,$^) $(LIBRARY) -lm -o $@
