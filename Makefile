# Lambent. `make help` lists what there is to make; everything is built into build/.

B ?= build
V ?=
Q := $(if $(V),,@)

LMB_CFLAGS := -std=c99 -O2 -g -Wall -Wextra -Wpedantic -Wshadow -Wundef -Wvla -Wconversion -Wmissing-prototypes -Ifirmware
# The library and the filler never touch a float; host programs do.
INTEGER_CFLAGS := -Wdouble-promotion -Wfloat-conversion
CXXFLAGS_ALL := -std=c++17 -O2 -g -Wall -Wextra
COMPILE = $(CC) $(LMB_CFLAGS) $(CPPFLAGS) $(CFLAGS) -MMD -MP

FIRMWARE := $(wildcard firmware/*.c)
PORT := $(wildcard port/*.c)
LIBRARY := $(FIRMWARE:%.c=$(B)/%.o) $(PORT:%.c=$(B)/%.o)
MESHES := icosphere_320 icosphere_1280 torus teapot
SCENES := $(MESHES:%=$(B)/meshes/%.o) $(B)/port/host/scenes.o
OBJ := $(B)/port/host/obj.o $(B)/port/host/polygon.o $(B)/port/host/mesh_build.o
TESTS := $(patsubst hosttest/%.c,%,$(wildcard hosttest/test_*.c))
TABLES := $(patsubst tables/gen_%.c,%,$(wildcard tables/gen_*.c))
# Generators of tables that are committed; the others write meshes at build time.
TABLES := $(filter-out icosphere torus teapot,$(TABLES))

.DEFAULT_GOAL := help
.PHONY: help demo check deps report figures pictures size exhaustive tables check-tables tools models tests clean
.DELETE_ON_ERROR:
.SECONDARY:

## help: this list
help:
	@echo "Lambent: glossy 3D on the displays of microcontrollers, with integers alone."
	@echo
	@sed -n 's/^## \([a-z-]*\): /  make \1|/p' Makefile | awk -F'|' '{ printf "%-22s %s\n", $$1, $$2 }'
	@echo
	@echo "  V=1 shows commands; CC, CFLAGS and B (the build folder, $(B)) are yours."

## demo: render the demo scenes into build/demo/*.bmp; needs a C compiler alone
demo: $(B)/bin/lmb-demo
	$(Q)mkdir -p $(B)/demo
	$(Q)$(B)/bin/lmb-demo $(B)/demo

## check: install what is missing, build everything, run every test; ends with "N passed, N failed"
check: deps
	$(Q)CC='$(CC)' MAKE='$(MAKE)' hosttest/check.sh

## deps: install what tests need (Debian packages; says which)
deps:
	$(Q)hosttest/deps.sh

## report: write build/report/*.csv, the errors of lobes, arcs, spans and images
report: report_tools
	$(Q)mkdir -p $(B)/report
	$(Q)for t in lobe arc span image; do \
	    echo "$(B)/report/$$t.csv"; $(B)/bin/report_$$t > $(B)/report/$$t.csv || exit 1; done

## figures: write the README's table of figures anew
figures: report
	$(Q)hosttest/size.sh $(B)/size > $(B)/report/size.txt; hosttest/figures.sh $(B)/report $(B)/report/size.txt

## pictures: write docs/pictures/*.png anew from the demo scenes (needs oiiotool)
pictures: demo
	$(Q)mkdir -p docs/pictures
	$(Q)oiiotool $(addprefix $(B)/demo/,teapot-tight.bmp torus.bmp icosphere-1280-tight.bmp) --mosaic 3x1 \
	    -o docs/pictures/gallery.png
	$(Q)oiiotool $(B)/demo/still-life.bmp -o docs/pictures/still-life.png

## size: bytes of flash on Cortex-M0+, by function, against the budget
size:
	$(Q)hosttest/size.sh $(B)/size

## exhaustive: the tests whose domain has 2^32 values; takes minutes
exhaustive: $(B)/bin/test_vec
	$(Q)$(B)/bin/test_vec exhaustive

## tables: write tables/*.h anew from their generators
tables: $(TABLES:%=$(B)/gen/gen_%)
	$(Q)for t in $(TABLES); do $(B)/gen/gen_$$t tables/$${t}_table.h || exit 1; done

## check-tables: generate all tables and compare with those that are committed
check-tables: $(TABLES:%=$(B)/gen/gen_%)
	$(Q)for t in $(TABLES); do \
	    $(B)/gen/gen_$$t $(B)/gen/$${t}_table.h && cmp $(B)/gen/$${t}_table.h tables/$${t}_table.h && \
	    echo "pass table $$t: generated anew, identical" || \
	    echo "FAIL table $$t: tables/$${t}_table.h is not what tables/gen_$$t.c writes; run make tables"; done

## tools: build/bin/lmb-mesh and build/bin/lmb-render
tools: $(B)/bin/lmb-mesh $(B)/bin/lmb-render

## models: build/models/*.obj, the demo's models to try lmb-render and lmb-mesh with
models: $(B)/models/teapot.obj $(B)/models/torus.obj $(B)/models/icosphere.obj

## tests: build the test programs without running them
tests: $(TESTS:%=$(B)/bin/%)

.PHONY: report_tools
report_tools: $(B)/bin/report_lobe $(B)/bin/report_arc $(B)/bin/report_span $(B)/bin/report_image

## clean: remove build/
clean:
	$(Q)rm -rf $(B)

# ------------------------------------------------------------------------------------------------------------------ the library

$(B)/firmware/%.o: firmware/%.c
	@mkdir -p $(@D)
	$(Q)$(COMPILE) $(INTEGER_CFLAGS) -c $< -o $@

$(B)/port/host/%.o: port/host/%.c
	@mkdir -p $(@D)
	$(Q)$(COMPILE) -c $< -o $@

$(B)/port/%.o: port/%.c
	@mkdir -p $(@D)
	$(Q)$(COMPILE) $(INTEGER_CFLAGS) -c $< -o $@

$(B)/liblambent.a: $(LIBRARY) $(B)/hosttest/checked.o
	$(Q)rm -f $@ && $(AR) rcs $@ $^

# -------------------------------------------------------------------------------------------------------------- meshes and tools

$(B)/gen/mesh_out.o: tables/mesh_out.c
	@mkdir -p $(@D)
	$(Q)$(COMPILE) -c $< -o $@

$(B)/gen/gen_%.o: tables/gen_%.c
	@mkdir -p $(@D)
	$(Q)$(COMPILE) -c $< -o $@

$(B)/gen/gen_icosphere $(B)/gen/gen_torus $(B)/gen/gen_teapot: $(B)/gen/gen_%: $(B)/gen/gen_%.o $(B)/gen/mesh_out.o
	$(Q)$(CC) $(LMB_CFLAGS) $(CFLAGS) $^ -o $@ $(LDFLAGS) -lm

$(B)/gen/gen_%: $(B)/gen/gen_%.o
	$(Q)$(CC) $(LMB_CFLAGS) $(CFLAGS) $^ -o $@ $(LDFLAGS) -lm

$(B)/meshes/icosphere_320.c: $(B)/gen/gen_icosphere
	@mkdir -p $(@D)
	$(Q)$< 2 mesh_icosphere_320 $@
$(B)/meshes/icosphere_1280.c: $(B)/gen/gen_icosphere
	@mkdir -p $(@D)
	$(Q)$< 3 mesh_icosphere_1280 $@
$(B)/meshes/torus.c: $(B)/gen/gen_torus
	@mkdir -p $(@D)
	$(Q)$< 48 24 mesh_torus $@
$(B)/meshes/teapot.c: $(B)/gen/gen_teapot
	@mkdir -p $(@D)
	$(Q)$< 6 mesh_teapot $@

$(B)/models/teapot.obj: $(B)/gen/gen_teapot
	@mkdir -p $(@D)
	$(Q)$< 6 teapot $@
$(B)/models/torus.obj: $(B)/gen/gen_torus
	@mkdir -p $(@D)
	$(Q)$< 48 24 torus $@
$(B)/models/icosphere.obj: $(B)/gen/gen_icosphere
	@mkdir -p $(@D)
	$(Q)$< 3 icosphere $@

$(B)/meshes/%.o: $(B)/meshes/%.c
	$(Q)$(COMPILE) -c $< -o $@

$(B)/bin/lmb-demo: $(B)/port/host/lmb_demo.o $(B)/port/host/bmp.o $(SCENES) $(B)/liblambent.a
$(B)/bin/lmb-mesh: $(B)/port/host/lmb_mesh.o $(OBJ) $(B)/liblambent.a
$(B)/bin/lmb-render: $(B)/port/host/lmb_render.o $(B)/port/host/bmp.o $(OBJ) $(B)/liblambent.a
$(B)/bin/lmb-demo $(B)/bin/lmb-mesh $(B)/bin/lmb-render:
	@mkdir -p $(@D)
	$(Q)$(LINK)

# ------------------------------------------------------------------------------------------------------------- tests and reports

$(B)/hosttest/%.o: hosttest/%.c
	@mkdir -p $(@D)
	$(Q)$(COMPILE) -c $< -o $@

$(B)/hosttest/%.o: hosttest/%.cc
	@mkdir -p $(@D)
	$(Q)$(CXX) $(CXXFLAGS_ALL) $$(pkg-config --cflags OpenImageIO) -MMD -MP -c $< -o $@

LINK = $(CC) $(LMB_CFLAGS) $(CFLAGS) $(filter %.o,$^) $(filter %.a,$^) -o $@ $(LDFLAGS) -lm
REFERENCE := $(patsubst %.c,$(B)/%.o,$(wildcard hosttest/reference*.c))

$(B)/bin/test_meshes: $(MESHES:%=$(B)/meshes/%.o)
$(B)/bin/test_raster $(B)/bin/test_terms: $(B)/hosttest/shapes.o
$(B)/bin/test_obj: $(B)/port/host/polygon.o $(B)/port/host/mesh_build.o
$(B)/bin/report_image: $(SCENES) $(REFERENCE)

$(B)/bin/test_image: $(B)/hosttest/test_image.o $(B)/hosttest/oiio.o $(SCENES) $(REFERENCE) $(B)/liblambent.a
	@mkdir -p $(@D)
	$(Q)$(CXX) $(CXXFLAGS_ALL) $(CFLAGS) $(filter %.o,$^) $(filter %.a,$^) -o $@ $(LDFLAGS) $$(pkg-config --libs OpenImageIO) -lm

$(B)/bin/test_%: $(B)/hosttest/test_%.o $(B)/liblambent.a
	@mkdir -p $(@D)
	$(Q)$(LINK)

$(B)/bin/report_%: $(B)/hosttest/report_%.o $(B)/liblambent.a
	@mkdir -p $(@D)
	$(Q)$(LINK)

-include $(shell find $(B) -name '*.d' 2>/dev/null)
