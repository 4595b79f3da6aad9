# Vectors for other people's implementations. VECTORS=N: at least N rows of a stage, in build/vectors.

VECTOR_GENERATOR := $(TEST_OUT)/vectors/from_library
VECTOR_FOLDER := $(if $(VECTORS),$(BUILD)/vectors,tests/vectors)

.PHONY: vectors
vectors: $(VECTOR_GENERATOR) ## test vectors of every stage: tests/vectors/; VECTORS=N: at least N rows of each
	@mkdir -p $(VECTOR_FOLDER)
	$(VECTOR_GENERATOR) $(VECTOR_FOLDER) $(VECTORS)
	tests/vectors/declare.sh $(VECTOR_FOLDER)

$(VECTOR_GENERATOR): $(patsubst %.c,$(TEST_OUT)/%.o,$(wildcard tests/vectors/from_library/*.c) port/crc32.c) $(LIBRARY)
	@mkdir -p $(@D)
	@echo "  LD  $@"
	@$(CC) $(CFLAGS) $^ -o $@

# The second generator, written from tests/SPEC.md alone: it sees no header of the library.
SPEC_GENERATOR := $(TEST_OUT)/vectors/from_spec

$(TEST_OUT)/tests/vectors/from_spec/%.o: TEST_CFLAGS = -std=c99 $(WARNINGS) -MMD -MP $(OPTIMISE) $(CFLAGS)

$(SPEC_GENERATOR): $(patsubst %.c,$(TEST_OUT)/%.o,$(wildcard tests/vectors/from_spec/*.c))
	@mkdir -p $(@D)
	@echo "  LD  $@"
	@$(CC) $(CFLAGS) $^ -lmpfr -lgmp -o $@
