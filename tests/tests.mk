# Tests on the host. Each C file in tests/unit and tests/accuracy is a program,
# linked with the library and the references; each script in tests/command,
# tests/static, tests/device and tests/packages is run from the top folder. All print TAP; tests/run
# adds up what they print.
#
# make check needs a C compiler and make; the rest needs what toolchain/setup installs.

TEST_OUT := $(BUILD)/tests
TEST_CFLAGS = -std=c99 $(WARNINGS) -MMD -MP -D_POSIX_C_SOURCE=200809L $(OPTIMISE) $(CFLAGS) \
	-Icore -Ifixedpoint -Iport -Itests -Itests/unit -Itests/reference -Itests/golden $(CMOCKA_CPPFLAGS)
TEST_LIBS = $(CMOCKA_LIBS) -lm

HASH := \#
CMOCKA_HEADERS := stdarg.h stddef.h stdint.h setjmp.h cmocka.h
CMOCKA_FOUND := $(if $(filter cmocka,$(WITHOUT)),,$(shell printf \
	'$(CMOCKA_HEADERS:%=$(HASH)include <%>\n)int main(void) { return 0; }\n' | \
	$(CC) $(CFLAGS) -x c - -lcmocka -o /dev/null 2>/dev/null && echo yes))
ifeq ($(CMOCKA_FOUND),yes)
CMOCKA_CPPFLAGS := -DHAVE_CMOCKA
CMOCKA_LIBS := -lcmocka
endif

REFERENCE_OBJECTS := $(patsubst %.c,$(TEST_OUT)/%.o,$(wildcard tests/reference/*.c))
GOLDEN_SOURCES := $(filter-out %_device.c,$(wildcard tests/golden/*.c)) port/crc32.c
UNIT_TESTS := $(patsubst tests/%.c,$(TEST_OUT)/%,$(wildcard tests/unit/*.c))
ACCURACY_TESTS := $(patsubst tests/%.c,$(TEST_OUT)/%,$(wildcard tests/accuracy/*.c))
EXHAUSTIVE_TESTS := $(patsubst tests/%.c,$(TEST_OUT)/%,$(wildcard tests/exhaustive/*.c))
GOLDEN_TEST := $(TEST_OUT)/golden/golden
SCRIPTS := $(sort $(wildcard $(patsubst %,tests/%/*.sh,command static device packages)))

.PHONY: check test-programs test-all exhaustive golden-update
check: $(UNIT_TESTS) $(GOLDEN_TEST) ## unit tests and golden scenes; needs no package
	@tests/run $(UNIT_TESTS) $(GOLDEN_TEST)

# The same programs, linked with the library of one source. Its warnings are errors too.
AMALGAMATED := $(TEST_OUT)/amalgamated
AMALGAMATED_TESTS := $(UNIT_TESTS:$(TEST_OUT)/%=$(AMALGAMATED)/%) $(AMALGAMATED)/golden/golden

.PHONY: check-amalgamation
check-amalgamation: $(AMALGAMATED_TESTS) ## the tests of make check with qvol.c of make amalgamation
	@tests/run $^

$(AMALGAMATED)/qvol.o: $(AMALGAMATION) $(OPTIONS)
	@mkdir -p $(@D)
	@echo "  CC  $<"
	@$(CC) $(LIBRARY_CFLAGS) -c $< -o $@

test-programs: $(UNIT_TESTS) $(ACCURACY_TESTS) $(GOLDEN_TEST)

test-all: all test-programs
	@BUILD=$(BUILD) QVOL=$(QVOL) CC="$(CC)" \
		tests/run $(UNIT_TESTS) $(GOLDEN_TEST) $(ACCURACY_TESTS) $(SCRIPTS)

exhaustive: $(EXHAUSTIVE_TESTS) $(TEST_OUT)/accuracy/splat_directions
	@QV_VIEWS=500 tests/run $^

golden-update: $(GOLDEN_TEST) ## write tests/golden/golden.h anew, after a change of the specification
	$(GOLDEN_TEST) --update > $(TEST_OUT)/golden.h
	cp $(TEST_OUT)/golden.h tests/golden/golden.h

.PHONY: bench-functions bench-blends bench-freevoxels
bench-functions: ## bytes, errors and instructions of the functions of optical depth
	tests/bench/functions.sh

bench-blends: ## instructions, RAM and flash of each way to blend slices
	tests/bench/blends.sh

bench-freevoxels: ## instructions, time and memory of FreeVoxels, beside memcpy and rays
	tests/bench/freevoxels.sh

TABLE_GENERATOR := $(TEST_OUT)/tables/tables

.PHONY: tables
tables: $(TABLE_GENERATOR) ## write the tables of fixedpoint/ anew; needs MPFR
	$(TABLE_GENERATOR) fixedpoint

$(TABLE_GENERATOR): $(patsubst %.c,$(TEST_OUT)/%.o,$(wildcard tests/tables/*.c))
	@mkdir -p $(@D)
	@echo "  LD  $@"
	@$(CC) $(CFLAGS) $^ -lmpfr -lgmp -o $@

RECOMMEND_GENERATOR := $(TEST_OUT)/recommend/recommend

.PHONY: recommend
recommend: $(RECOMMEND_GENERATOR) ## measure the table of qv_recommend anew: some minutes
	$(RECOMMEND_GENERATOR) $(TEST_OUT)/recommend_table.h
	cp $(TEST_OUT)/recommend_table.h core/recommend_table.h

$(RECOMMEND_GENERATOR): $(TEST_OUT)/tests/recommend/recommend.o $(REFERENCE_OBJECTS) $(LIBRARY)
	@mkdir -p $(@D)
	@echo "  LD  $@"
	@$(CC) $(CFLAGS) $^ -lm -o $@

# The errors of `qvol advise`, and its table with what modes cost on devices.
ADVISE_ERRORS := $(TEST_OUT)/advise/errors
ADVISE_TARGETS := cortex-m0 cortex-m3 cortex-m4 cortex-m7 cortex-m33 cortex-m55 rv32imc rv32ec avr \
	powerpc host-gcc

.PHONY: advise
advise: $(ADVISE_ERRORS) ## measure the table of qvol advise anew: some minutes
	{ $(ADVISE_ERRORS) && tests/bench/advise.sh costs $(ADVISE_TARGETS); } >$(BUILD)/advise
	tests/bench/advise.sh table <$(BUILD)/advise >$(BUILD)/advise_table.h
	cp $(BUILD)/advise_table.h port/host/advise_table.h

ADVISE_SOURCES := $(wildcard tests/advise/*.c tests/papers/*.c) tests/bench/bench_modes.c

$(ADVISE_ERRORS): $(ADVISE_SOURCES:%.c=$(TEST_OUT)/%.o) $(REFERENCE_OBJECTS) $(LIBRARY)
	@mkdir -p $(@D)
	@echo "  LD  $@"
	@$(CC) $(CFLAGS) $(filter %.o,$^) $(LIBRARY) -lm -o $@

# The papers' figures: a program for each paper, of a folder of its own and what all share.
PAPER_PROGRAMS := $(addprefix $(TEST_OUT)/papers/,wittenbrink kraus dithering freevoxels)
paper_objects = $(patsubst %.c,$(TEST_OUT)/%.o,$(wildcard tests/papers/*.c tests/papers/$(1)/*.c))

.PHONY: paper-programs
paper-programs: $(PAPER_PROGRAMS) $(TEST_OUT)/accuracy/splat_directions $(QVOL)

$(TEST_OUT)/papers/wittenbrink: $(call paper_objects,wittenbrink)
$(TEST_OUT)/papers/kraus: $(call paper_objects,kraus)
$(TEST_OUT)/papers/dithering: $(call paper_objects,dithering)
$(TEST_OUT)/papers/freevoxels: $(call paper_objects,freevoxels)

$(PAPER_PROGRAMS): $(REFERENCE_OBJECTS) $(LIBRARY)
	@mkdir -p $(@D)
	@echo "  LD  $@"
	@$(CC) $(CFLAGS) $(filter %.o,$^) $(LIBRARY) -lm -o $@

include tests/precision/precision.mk
include tests/vectors/vectors.mk

.PHONY: mutants
mutants: ## change each constant, shift and rounding: do the test vectors notice? An hour or two
	/usr/bin/python3 tests/mutation/mutate.py --out $(BUILD)/mutants

TEST_OPTIONS := $(call remember,$(TEST_OUT)/options,$(CC) $(TEST_CFLAGS) $(TEST_LIBS))

$(TEST_OUT)/%.o: %.c $(TEST_OPTIONS)
	@mkdir -p $(@D)
	@echo "  CC  $<"
	@$(CC) $(TEST_CFLAGS) -c $< -o $@

$(UNIT_TESTS) $(ACCURACY_TESTS) $(EXHAUSTIVE_TESTS): $(TEST_OUT)/%: $(TEST_OUT)/tests/%.o $(REFERENCE_OBJECTS) $(LIBRARY)
	@mkdir -p $(@D)
	@echo "  LD  $@"
	@$(CC) $(CFLAGS) $^ $(TEST_LIBS) -o $@

$(filter-out %/golden,$(AMALGAMATED_TESTS)): $(AMALGAMATED)/%: $(TEST_OUT)/tests/%.o $(REFERENCE_OBJECTS) $(AMALGAMATED)/qvol.o
	@mkdir -p $(@D)
	@echo "  LD  $@"
	@$(CC) $(CFLAGS) $^ $(TEST_LIBS) -o $@

$(GOLDEN_TEST): $(LIBRARY)
$(AMALGAMATED)/golden/golden: $(AMALGAMATED)/qvol.o
$(GOLDEN_TEST) $(AMALGAMATED)/golden/golden: $(GOLDEN_SOURCES:%.c=$(TEST_OUT)/%.o) $(REFERENCE_OBJECTS)
	@mkdir -p $(@D)
	@echo "  LD  $@"
	@$(CC) $(CFLAGS) $^ $(TEST_LIBS) -o $@

-include $(shell find $(TEST_OUT) -name '*.d' 2>/dev/null)
.SECONDARY:
