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
SCENES := $(MESHES:%=$(B)/meshes/%.o) $(B)/port/demo/scenes.o
OBJ := $(B)/port/host/obj.o $(B)/port/host/polygon.o $(B)/port/host/mesh_build.o
TESTS := $(patsubst hosttest/%.c,%,$(wildcard hosttest/test_*.c))
TABLES := $(patsubst tables/gen_%.c,%,$(wildcard tables/gen_*.c))
# Generators of tables that are committed; the others write meshes at build time.
TABLES := $(filter-out icosphere torus teapot,$(TABLES))

# MORE: a file with blocks of your own.
BLOCKS := port/targets.mk hosttest/variants.mk $(MORE)
include port/targets.mk $(MORE) hosttest/variants.mk
override TARGET := $(patsubst cortex-%,%,$(TARGET))
ifneq ($(filter-out $(TARGETS) $(VARIANTS),$(TARGET)),)
$(error unknown TARGET=$(TARGET); known: $(TARGETS); and to compare frames: $(VARIANTS))
endif
CHOSEN = $(or $(TARGET),$(TARGETS))
COMPARED = $(or $(TARGET),$(TARGETS) $(filter-out reference,$(VARIANTS)))
GATED = $(filter-out host-big-endian,$(COMPARED))
# Whole frames and their depth want more than 8 KB.
DIGESTED = $(filter-out atmega328p m3-stm32vl reference,$(COMPARED))
# What size and stack are about: targets of their own, of which the small AVR is none.
WEIGHABLE := $(filter-out host atmega328p,$(TARGETS))
WEIGHED := $(if $(TARGET),$(filter $(TARGET),$(WEIGHABLE)),$(WEIGHABLE))
STACKED := gloss-Os everything-Os gloss-O2 everything-O2
# What docs/CHOOSING.md weighs beside what every core does, and for which cores.
CHOICES := gouraud arc planned rgb888
CHOOSING := m0plus m4 rv32imc atmega1284p
PARTS := ARC PLANS QUADRATIC GLOSS CORNERS GOURAUD PERSPECTIVE DEPTH LARGE LOBES RGB565 RGB888 LIGHTS

.DEFAULT_GOAL := help
.PHONY: help demo check deps report replicate stability time charts figures choosing pictures size exhaustive tables check-tables tools models tests clean
.PHONY: pareto firmware run boards frames digests gate profile stack budgets
.DELETE_ON_ERROR:
.SECONDARY:

## help: this list
help:
	@echo "Lambent: glossy 3D on the displays of microcontrollers, with integers alone."
	@echo
	@sed -n 's/^## \([a-z_-]*\): /  make \1|/p' Makefile | awk -F'|' '{ printf "%-22s %s\n", $$1, $$2 }'
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

## report: write build/report/*.csv: errors of lobes, arcs, spans, images; plans; sizes, cycles, growth, estimates; papers, stability, pareto
REPORTS := lobe arc span image plan size cycles kernel_cycles growth growth_model estimate papers stability pareto
report: $(REPORTS:%=$(B)/report/%.csv)

## replicate: what three papers claim beside what we measure, claim by claim; report/papers.csv, docs/REPLICATION.md
replicate: $(B)/bin/replicate $(B)/bin/stability $(B)/report/kernel_cycles.csv $(B)/report/arc.csv $(B)/report/papers.csv
	$(Q)$(B)/bin/replicate $(B)/report
	$(Q)hosttest/replicate.sh $(B)/bin $(B)/report

## stability: where each method is safe and what it does elsewhere, by sweeps; report/stability.csv
stability: $(B)/bin/stability $(B)/report/stability.csv
	$(Q)$(B)/bin/stability

## pareto: speed against accuracy of every lobe, way along a span and frame, charted; report/pareto.csv, docs/charts/pareto-*
pareto: $(B)/bin/chart_data $(B)/report/pareto.csv
	$(Q)mkdir -p $(B)/charts
	$(Q)$(B)/bin/chart_data $(B)/charts pareto
	$(Q)hosttest/charts.sh $(B)/charts docs/charts $(basename $(notdir $(wildcard hosttest/charts/pareto-*.gp)))
	$(Q)hosttest/pareto/page.sh $(B)/report/pareto.csv
	$(Q)hosttest/test_pareto.sh $(B)/report/pareto.csv

## time: nanoseconds a pixel of the ways along a span, on this machine
time: $(B)/bin/time_steps
	$(Q)$(B)/bin/time_steps

## charts: draw docs/charts/*.svg and *.png anew from what we measure (needs gnuplot)
charts: $(B)/bin/chart_data $(addprefix $(B)/report/,kernel_cycles.csv growth.csv growth_model.csv estimate.csv pareto.csv)
	$(Q)mkdir -p $(B)/charts
	$(Q)$(B)/bin/chart_data $(B)/charts
	$(Q)hosttest/charts.sh $(B)/charts docs/charts
	$(Q)for d in hosttest/charts/*.flow; do hosttest/flow.sh $$d docs/charts/$$(basename $$d .flow).svg || exit 1; done

## figures: write the README's table of figures anew
figures: report
	$(Q)hosttest/figures.sh $(B)/report

## choosing: write docs/CHOOSING.md's tables and pictures anew: model, step and lobe beside cycles, bytes and errors
choosing: choosing-pictures $(patsubst %,$(B)/report/%.csv,cycles size kernel_cycles lobe image plan)
	$(Q)hosttest/choosing.sh $(B)/report

# Demo scenes by every choice beside the exact frame.
PICTURED := icosphere-320-tight teapot
.PHONY: choosing-pictures
choosing-pictures: $(B)/bin/picture_choosing
	$(Q)mkdir -p docs/pictures
	$(Q)set -e; for s in $(PICTURED); do \
	    hosttest/choosing_picture.sh $< $$s $(B)/choosing/$$s docs/pictures/choosing-$$s.png; done

## pictures: write docs/pictures/*.png and figure 3 of paper 001 anew from the demo scenes (needs oiiotool)
pictures: demo choosing-pictures $(B)/bin/picture_arc
	$(Q)mkdir -p docs/pictures
	$(Q)oiiotool $(addprefix $(B)/demo/,teapot-tight.bmp torus.bmp icosphere-1280-tight.bmp) --mosaic 3x1 \
	    -o docs/pictures/gallery.png
	$(Q)oiiotool $(B)/demo/still-life.bmp -o docs/pictures/still-life.png
	$(Q)mkdir -p docs/charts && $(B)/bin/picture_arc $(B)/demo/paper-001-figure-3.ppm
	$(Q)oiiotool $(B)/demo/paper-001-figure-3.ppm -o docs/charts/paper-001-figure-3.png

## firmware: build/firmware/TARGET/frames.elf for all targets, or TARGET=...; sizes of each
firmware: $(CHOSEN:%=$(B)/firmware/%/frames.elf)
	$(Q)set -e; $(foreach t,$(CHOSEN),hosttest/sections.sh $t "$($t.prefix)" $(B)/firmware/$t/frames.elf;)

## run: draw the demo scenes on emulated boards, all or TARGET=..., into build/frames/TARGET/*.565
run: $(CHOSEN:%=run-%)

## frames: the same with more compilers and options, compared byte for byte with the host's; report/frames.csv if all
frames: $(COMPARED:%=compare-%)
	@mkdir -p $(B)/report
	$(Q)$(if $(TARGET),:,{ echo target,scene,bytes,crc32,matches_host; cat $(CHOSEN:%=$(B)/frames/%/frames.csv); } > $(B)/report/frames.csv)
	$(Q)cat $(COMPARED:%=$(B)/frames/%/verdict); ! grep -q "^FAIL" $(COMPARED:%=$(B)/frames/%/verdict)

## boards: start-up, console, files, counter and faults of each board, or TARGET=...
boards: $(CHOSEN:%=board-%)
	$(Q)cat $(CHOSEN:%=$(B)/boards/%/verdict); ! grep -q "^FAIL" $(CHOSEN:%=$(B)/boards/%/verdict)

## digests: mathematics, lobes, arcs and every model on all targets, or TARGET=..., compared with the host's by their hashes
digests: $(DIGESTED:%=digest-%)
	$(Q)cat $(DIGESTED:%=$(B)/digests/%/verdict); ! grep -q "^FAIL" $(DIGESTED:%=$(B)/digests/%/verdict)

## gate: objects and images of all targets, or TARGET=..., hold no division, square root or float
gate: $(GATED:%=gate-%)
	$(Q)cat $(GATED:%=$(B)/gate/%); ! grep -q "^FAIL" $(GATED:%=$(B)/gate/%)

## profile: instructions and cycles of frames by function; TARGET=... [SCENE=...] [MODEL=...] [LIST=function]
profile: $(if $(TARGET),profile-$(TARGET),profile-help)

## size: text, rodata, data, bss and stack of each configuration and its largest functions, all targets or TARGET=...
size: $(WEIGHED:%=$(B)/size/%/size.txt) $(if $(filter m0plus,$(WEIGHED)),$(B)/size/m0plus/parts.txt)
	$(Q)[ -n "$(WEIGHED)" ] || { echo "size: $(TARGET) is not weighed"; exit 1; }; cat $^

## stack: deepest chains of calls on all targets, or TARGET=..., and how deep the stack of an emulated one really goes
stack: $(WEIGHED:%=$(B)/size/%/stack.txt)
	$(Q)[ -n "$(WEIGHED)" ] || { echo "stack: $(TARGET) is not followed"; exit 1; }; cat $^; ! grep -q "^FAIL" $^ /dev/null

## estimate: lmb-estimate beside the profiler on frames that it was not fitted on; TARGET=..., FRAMES=list, MODELS=folder of yours
## costs: measure, fit and write anew what lmb-estimate multiplies by: port/host/costs_table.h, flash_table.h; minutes
## growth_tables: write the tables of docs/GROWTH.md anew
## estimate_flash: two linked images beside the bytes of flash that lmb-estimate tells
# All four: hosttest/estimate/estimate.mk.

## budgets: the figures of the last make report against hosttest/budgets.txt
budgets:
	$(Q)hosttest/budgets.sh $(B)/report hosttest/budgets.txt

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

## tools: build/bin/lmb-mesh, build/bin/lmb-render and build/bin/lmb-estimate
tools: $(B)/bin/lmb-mesh $(B)/bin/lmb-render $(B)/bin/lmb-estimate

## models: build/models/*.obj, the demo's models to try lmb-render and lmb-mesh with
models: $(B)/models/teapot.obj $(B)/models/torus.obj $(B)/models/icosphere.obj

## tests: build the test programs without running them
tests: $(TESTS:%=$(B)/bin/%)

.PHONY: report_tools
report_tools: $(B)/bin/report_lobe $(B)/bin/report_arc $(B)/bin/report_span $(B)/bin/report_image $(B)/bin/report_plan $(B)/bin/picture_choosing

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

$(B)/gen/gen_icosphere $(B)/gen/gen_torus $(B)/gen/gen_teapot: $(B)/gen/gen_%: $(B)/gen/gen_%.o $(B)/gen/mesh_out.o $(B)/liblambent.a
	$(Q)$(CC) $(LMB_CFLAGS) $(CFLAGS) $^ -o $@ $(LDFLAGS) -lm

$(B)/gen/gen_%: $(B)/gen/gen_%.o
	$(Q)$(CC) $(LMB_CFLAGS) $(CFLAGS) $^ -o $@ $(LDFLAGS) -lm

# icosphere_N: N = 20 * 4^times
sphere.20 := 0
sphere.80 := 1
sphere.320 := 2
sphere.1280 := 3
sphere.5120 := 4
sphere.20480 := 5
SPHERES := 20 80 320 1280 5120 20480
$(SPHERES:%=$(B)/meshes/icosphere_%.c): $(B)/meshes/icosphere_%.c: $(B)/gen/gen_icosphere
	@mkdir -p $(@D)
	$(Q)$< $(sphere.$*) mesh_icosphere_$* $@
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
$(B)/bin/lmb-render: $(B)/port/host/lmb_render.o $(B)/port/host/view.o $(B)/port/host/bmp.o $(OBJ) $(B)/liblambent.a
$(B)/bin/lmb-demo $(B)/bin/lmb-mesh $(B)/bin/lmb-render:
	@mkdir -p $(@D)
	$(Q)$(LINK)

# -------------------------------------------------------------------------------------------------------- firmware for the targets

# Boards link with nothing but what is here and the compiler's own helpers.
BARE_LINK = -nostartfiles -nostdlib -Wl,--gc-sections -Wl,--fatal-warnings -L linker -T $($1.ld) -lgcc
SCENES_OF = $(if $(filter-out all,$($1.scenes)),-DSCENES='(0$(foreach s,$(shell echo $($1.scenes) | tr a-z- A-Z_),|SCENE_WITH_$s))')

# firmware_rules TARGET: build/firmware/TARGET/NAME.elf from port/demo/NAME.c, the scenes, the board and the library. Whatever is
# under a folder of sources is built into the same folder there.
define firmware_rules
$1.cc ?= $$($1.prefix)gcc
$1.link ?= $$(call BARE_LINK,$1)
$1.sources ?= $$(wildcard port/$$($1.board)/*.c port/$$($1.board)/*.S) port/demo/memory.c
$1.support = $$(patsubst %,$$(B)/firmware/$1/%.o,$$(basename $$($1.sources)) port/demo/scenes $$(MESHES:%=meshes/%))
$1.compile = $$($1.cc) $$(LMB_CFLAGS) $$(INTEGER_CFLAGS) -ffreestanding -ffunction-sections -fdata-sections $$($1.flags)

$$(B)/firmware/$1/port/demo/%.o: private SPECIAL = -DLMB_STRIP_BYTES=$$($1.strip) $$(call SCENES_OF,$1)

$$(B)/firmware/$1/%.o: %.c $$(BLOCKS)
	@mkdir -p $$(@D)
	$$(Q)$$($1.compile) $$(SPECIAL) $$(CPPFLAGS) $$(CFLAGS) -MMD -MP -c $$< -o $$@

$$(B)/firmware/$1/%.o: %.S $$(BLOCKS)
	@mkdir -p $$(@D)
	$$(Q)$$($1.compile) $$(SPECIAL) $$(CPPFLAGS) $$(CFLAGS) -MMD -MP -c $$< -o $$@

$$(B)/firmware/$1/meshes/%.o: $$(B)/meshes/%.c $$(BLOCKS)
	@mkdir -p $$(@D)
	$$(Q)$$($1.compile) $$(SPECIAL) $$(CPPFLAGS) $$(CFLAGS) -MMD -MP -c $$< -o $$@

$$(B)/firmware/$1/liblambent.a: $$(patsubst %.c,$$(B)/firmware/$1/%.o,$$(FIRMWARE) $$(PORT))
	$$(Q)rm -f $$@ && $$($1.prefix)ar rcs $$@ $$^

$$(B)/firmware/$1/%.elf: $$(B)/firmware/$1/port/demo/%.o $$($1.support) $$(B)/firmware/$1/liblambent.a $$($1.ld) $$(wildcard linker/*sections.ld)
	$$(Q)$$($1.compile) $$(CFLAGS) $$(filter %.o %.a,$$^) -o $$@ $$($1.link) $$(LDFLAGS)

.PHONY: run-$1 compare-$1 gate-$1 board-$1 digest-$1
run-$1: $$(B)/firmware/$1/frames.elf $$($1.needs)
	$$(Q)echo "$1: $$(if $$($1.without),$$($1.scenes); others are left out: $$($1.without),all scenes)"
	$$(Q)hosttest/frames.sh run $$(B)/frames/$1 $$(call $1.run,$$(abspath $$<))

compare-$1: $$(B)/firmware/$1/frames.elf $$(B)/bin/crc32 reference-frames $$($1.needs)
	$$(Q)hosttest/frames.sh run $$(B)/frames/$1 $$(call $1.run,$$(abspath $$<)) > /dev/null || true
	$$(Q)hosttest/frames.sh compare $1 $$(B)/frames/$1 $$(B)/frames/reference $$(B)/bin/crc32 "$$($1.scenes)" "$$($1.without)" \
	    > $$(B)/frames/$1/verdict

board-$1: $$(B)/firmware/$1/selftest.elf $$(if $$($1.fault),$$(B)/firmware/$1/fault.elf) $$($1.needs)
	@mkdir -p $$(B)/boards
	$$(Q)hosttest/boards.sh $1 $$(B)/boards/$1 "$$($1.prefix)nm" "$$($1.counter)" "$$($1.fault)" \
	    $$(abspath $$(B)/firmware/$1/selftest.elf $$(B)/firmware/$1/fault.elf) \
	    $$(call $1.run,IMAGE) > $$(B)/boards/$1.verdict; \
	    mv $$(B)/boards/$1.verdict $$(B)/boards/$1/verdict

digest-$1: $$(B)/firmware/$1/digest.elf $$(B)/firmware/reference/digest.elf $$($1.needs)
	@mkdir -p $$(B)/digests
	$$(Q)hosttest/digest.sh $1 $$(abspath $$(B)/digests/$1) $$(abspath $$(B)/firmware/reference/digest.elf) \
	    $$(call $1.run,$$(abspath $$<)) > $$(B)/digests/$1.verdict; mv $$(B)/digests/$1.verdict $$(B)/digests/$1/verdict

# A board that links with a libc holds what that brings along: only its objects are judged.
gate-$1: $$(B)/firmware/$1/liblambent.a $$(B)/firmware/$1/frames.elf
	@mkdir -p $$(B)/gate
	$$(Q)hosttest/gate.sh $1 "$$($1.prefix)" "$$($1.calls)" $$< $$(if $$($1.ld),$$(B)/firmware/$1/frames.elf) > $$(B)/gate/$1 || true
endef
$(foreach t,$(TARGETS) $(VARIANTS),$(eval $(call firmware_rules,$t)))

.PHONY: reference-frames
reference-frames: $(B)/firmware/reference/frames.elf
	$(Q)hosttest/frames.sh run $(B)/frames/reference $(abspath $<) > /dev/null

$(B)/bin/crc32: $(B)/hosttest/crc32.o
	@mkdir -p $(@D)
	$(Q)$(LINK)

$(B)/bin/avr-run: $(B)/hosttest/avr_run.o
	@mkdir -p $(@D)
	$(Q)$(LINK) -lsimavr

include hosttest/profile/profile.mk
include hosttest/estimate/estimate.mk

# --------------------------------------------------------------------------------------------------------------- sizes and stacks

# size_rules TARGET: build/size/TARGET/CONFIGURATION-OPTIMISATION/*.elf and what is read off them.
# A source of the board that is named as a helper of libgcc stands for one that is missing there.
WEIGHED_FILES := $(wildcard firmware/*.[ch] port/*.[ch] tables/*_table.h hosttest/size_* hosttest/size.ld)
define size_rules
$$(B)/size/$1/%/whole.elf: $$(WEIGHED_FILES) port/targets.mk
	$$(Q)hosttest/size_image.sh $$(@D) "$$($1.prefix)" "$$(filter-out -DLMB_LOOPS=1,$$($1.flags))" $$(filter %di3.c,$$($1.sources))

$$(B)/size/$1/%/marked.elf: $$(B)/size/$1/%/whole.elf $$(B)/meshes/icosphere_320.c $$(wildcard hosttest/stack*) $$($1.sources) $$($1.ld)
	$$(Q)hosttest/stack_image.sh $$(@D) "$$($1.prefix)" "$$(filter-out -DLMB_LOOPS=1,$$($1.flags))" "$$($1.link)" $$(B)/meshes/icosphere_320.c $$($1.sources)

$$(B)/size/$1/size.txt: hosttest/size.sh $$(wildcard hosttest/stack.*) $$(foreach c,empty flat diffuse gloss everything $$(if $$(filter $1,$$(CHOOSING)),$$(CHOICES)),$$(B)/size/$1/$$c-Os/whole.elf)
	$$(Q)hosttest/size.sh table $1 "$$($1.prefix)" $$(@D) > $$@

$$(B)/size/$1/size.csv: $$(B)/size/$1/size.txt
	$$(Q)hosttest/size.sh csv $1 "$$($1.prefix)" $$(@D) > $$@

$$(B)/size/$1/parts.txt: $$(B)/size/$1/size.txt $$(foreach p,$$(PARTS),$$(B)/size/$1/without-$$p-Os/whole.elf)
	$$(Q)hosttest/size.sh parts $1 "$$($1.prefix)" $$(@D) > $$@

# A verdict that fails is still a verdict: make stack shows them all and fails then.
$$(B)/size/$1/stack.txt: $$(foreach s,$$(STACKED),$$(B)/size/$1/$$s/marked.elf) $$($1.needs)
	$$(Q){ $$(foreach s,$$(STACKED),hosttest/stack.sh chains "$$($1.prefix)" $$(@D)/$$s "$1 $$s"; \
	    hosttest/stack.sh watermark "$$($1.prefix)" $$(@D)/$$s "$1 $$s" $$(call $1.run,$$(abspath $$(@D))/$$s/marked.elf); )true; } > $$@ 2>&1
endef
$(foreach t,$(WEIGHABLE),$(eval $(call size_rules,$t)))

$(B)/report/size.csv: $(WEIGHABLE:%=$(B)/size/%/size.csv)
	@mkdir -p $(@D)
	$(Q){ echo core,configuration,text,rodata,data,bss,stack; cat $^; } > $@

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
$(B)/bin/test_raster $(B)/bin/test_rows $(B)/bin/test_seam $(B)/bin/test_terms: $(B)/hosttest/shapes.o
$(B)/bin/report_plan: $(SCENES)
$(B)/bin/test_squares: $(B)/hosttest/estimate/squares.o
$(B)/bin/test_obj: $(B)/port/host/polygon.o $(B)/port/host/mesh_build.o
$(B)/bin/test_compare: $(patsubst %.c,$(B)/%.o,$(wildcard hosttest/compare/*.c)) $(SCENES) $(REFERENCE)

# The papers, method by method: definitions in double, integer forms of comparisons, sweeps, claims and charts.
PAPER_PROGRAMS := replicate chart_data stability
PAPERS := $(filter-out $(PAPER_PROGRAMS:%=$(B)/hosttest/papers/%.o), \
    $(patsubst %.c,$(B)/%.o,$(wildcard hosttest/papers/*.c hosttest/compare/*.c)))
$(PAPER_PROGRAMS:%=$(B)/bin/%): $(B)/bin/%: $(B)/hosttest/papers/%.o
$(B)/bin/time_steps: $(B)/hosttest/time_steps.o
$(PAPER_PROGRAMS:%=$(B)/bin/%) $(B)/bin/time_steps: $(PAPERS) $(B)/liblambent.a
	@mkdir -p $(@D)
	$(Q)$(LINK)
$(patsubst %,$(B)/bin/%,$(filter test_papers%,$(TESTS))): $(PAPERS)
$(B)/bin/test_rotation: $(B)/hosttest/papers/rotation.o
$(B)/bin/report_lobe $(B)/bin/report_arc: $(PAPERS)
include hosttest/pareto/pareto.mk

$(B)/bin/picture_%: $(B)/hosttest/picture_%.o $(SCENES) $(REFERENCE) $(B)/liblambent.a
	@mkdir -p $(@D)
	$(Q)$(LINK)

# What judges whole frames, with OpenImageIO.
JUDGES := test_image test_exact report_image
$(JUDGES:%=$(B)/bin/%): $(B)/bin/%: $(B)/hosttest/%.o $(B)/hosttest/oiio.o $(B)/hosttest/seen.o $(SCENES) $(REFERENCE) $(B)/liblambent.a
	@mkdir -p $(@D)
	$(Q)$(CXX) $(CXXFLAGS_ALL) $(CFLAGS) $(filter %.o,$^) $(filter %.a,$^) -o $@ $(LDFLAGS) $$(pkg-config --libs OpenImageIO) -lm

$(B)/bin/test_%: $(B)/hosttest/test_%.o $(B)/liblambent.a
	@mkdir -p $(@D)
	$(Q)$(LINK)

$(patsubst %,$(B)/report/%.csv,lobe arc span image plan): $(B)/report/%.csv: $(B)/bin/report_%
	@mkdir -p $(@D)
	@echo $@
	$(Q)$< > $@

$(B)/report/papers.csv: $(B)/bin/replicate $(B)/report/kernel_cycles.csv
	@echo $@
	$(Q)$< --csv $(B)/report > $@

$(B)/report/stability.csv: $(B)/bin/stability
	@mkdir -p $(@D)
	@echo $@
	$(Q)$< --csv 2> /dev/null > $@

$(B)/bin/report_%: $(B)/hosttest/report_%.o $(B)/liblambent.a
	@mkdir -p $(@D)
	$(Q)$(LINK)

-include $(shell find $(B) -name '*.d' 2>/dev/null)
