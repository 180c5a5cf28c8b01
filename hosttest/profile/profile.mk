# SPDX-License-Identifier: MIT
# The profiler and what it runs; read by the Makefile. make profile TARGET=... [SCENE=...] [MODEL=...] [LIST=function]
#
# A target's benchmark is the library as its firmware links it, with bench.c and kernels.c, in a memory that holds a whole frame
# where there is one. build/profile/TARGET/ holds three images: chosen, with the SCENE and MODEL of this call of make; all, with
# everything, for the report; test, programs whose figures are known. Each has its listing (.lst) and what the profiler wrote
# (.out).

PROFILE := hosttest/profile
PROFILER := $(addprefix $(PROFILE)/,trace.c program.c cycles.c)
PROFILE_HEADERS := $(wildcard $(PROFILE)/*.h)
PROFILED := $(filter m0plus m0 m3 m4 m33 m55 rv32imc rv32i rv32ec atmega1284p lx106 \
    $(if $(filter x86_64,$(shell uname -m)),host),$(TARGETS))

# ----------------------------------------------------------------------------------------------------------------- per target

# Spheres of so many triangles beside those of the scenes, and the cores on which growth is measured: their emulators have room.
GROWTH := 20 80 5120 20480
GROWING := m0plus m4 rv32imc

# NAME.profile_ld       memory map of the benchmark, where the board's has no room for a frame
# NAME.profile_run      command, where it is another: $(1) is the image, $(2) options for QEMU
# NAME.profile_flags    for the benchmark
# NAME.profile_options  for the plugin
# NAME.profile_split    frames, kernels, and methods alone (models lobe..., step-...) are three images

# Thumb-1 code in the memory of an MPS2, whose Cortex-M3 executes it as a Cortex-M0 does: the micro:bit has 16 KB.
m0plus.profile_ld := linker/mps2-an385.ld
m0plus.profile_run = $(call qemu-arm,mps2-an385) $(1) $(2)
m0.profile_ld := linker/mps2-an385.ld
m0.profile_run = $(call qemu-arm,mps2-an385) $(1) $(2)

rv32imc.profile_ld := $(PROFILE)/rv32.ld
rv32i.profile_ld := $(PROFILE)/rv32.ld
rv32ec.profile_ld := $(PROFILE)/rv32.ld

# Division and floats are in the ROM of the ESP8266 and not in its libgcc: nothing to compare with.
lx106.profile_ld := $(PROFILE)/lx106.ld
lx106.profile_flags := -DLMB_PROFILE_COMPARED=0

# 16 KB of RAM: frames strip by strip, and kernels on a smaller surface. 128 KB of flash: two scenes, and frames, kernels and
# what is compared alone in images of their own.
atmega1284p.profile_ld := $(PROFILE)/atmega1284p.ld
atmega1284p.profile_split := yes
atmega1284p.profile_flags := -DLMB_PROFILE_SIZE=128 -DLMB_PROFILE_BYTES=10752 \
    -DSCENES="(SCENE_WITH_ICOSPHERE_320|SCENE_WITH_ICOSPHERE_128)"

# Where an x86 instruction crosses a page, QEMU 7.2 reports it in two translations and executes it in one: so one by one.
host.profile_run = qemu-x86_64 $(2) $(1)
host.profile_options := each=on

# ------------------------------------------------------------------------------------------------------------------- commands

comma := ,
space := $(subst ,, )

# Comparisons use floats; they need a libm, which may need its libc: where the tool chain has them.
profile_libm = $(filter /%,$(foreach l,libm.a $(if $($1.ld),libc.a),$(shell $($1.cc) $($1.flags) -print-file-name=$l)))
profile_ld = $(or $($1.profile_ld),$($1.ld))
profile_link = $(if $($1.ld),$(subst -T $($1.ld),-T $(profile_ld),$($1.link)),-static -no-pie $($1.link))
profile_flags = $($1.profile_flags) $(if $(findstring SCENES,$($1.profile_flags)),,$(SCENES_OF)) \
    -Wno-double-promotion -Wno-float-conversion -fno-math-errno -DCOMPARE_WITH_LIBM=$(if $(profile_libm),1,0)
profile_listing = $($1.prefix)objdump -t -d -w -z $2.elf > $2.lst

profile_compared = $(if $(findstring COMPARED=0,$($1.profile_flags)),,$(wildcard hosttest/compare/*.c))
profile_objects = $(patsubst %.c,$(B)/firmware/$1/%.o,$(addprefix $(PROFILE)/,bench.c kernels.c lobe_kernels.c step_kernels.c sweep.c mark.c) hosttest/pareto/methods.c $(profile_compared))
profile_tests = $(addprefix $(B)/firmware/$1/$(PROFILE)/,test_main.o mark.o \
    $(if $(filter arm-%,$($1.prefix)),test_thumb.o) $(if $(filter avr-,$($1.prefix)),test_avr.o))

# profile_execute TARGET,IMAGE: runs IMAGE.elf under the profiler, which writes IMAGE.out. A QEMU takes its options at the end.
profile_options = $(strip $($1.profile_options) $(if $(LIST),at=on) $(if $(SCENE),,progress=on) $(PROFILE_EXTRA))
profile_core = $1$(if $(filter 32,$(MULTIPLIER)),$(if $(filter m0plus m0,$1),-mul32,$(error MULTIPLIER=32 is for m0plus and m0)))
profile_plugin = -plugin file=$(abspath $(B)/profile/plugin.so),core=$(profile_core),listing=$2.lst,out=$2.out$(addprefix \
    $(comma),$(subst $(space),$(comma),$(profile_options)))
profile_avr = $(abspath $(B)/profile/avr) $1 $2.elf $2.lst $2.out $(profile_options)
profile_run = $(if $($1.profile_run),$(call $1.profile_run,$2,$3),$(call $1.run,$2 $3))
profile_execute = $(if $(filter avr-,$($1.prefix)),$(profile_avr),$(call profile_run,$1,$2.elf,$(if \
    $(filter-out host,$1),-icount shift=0) $(profile_plugin)))

# ---------------------------------------------------------------------------------------------------------------------- tools

profile_build = $(CC) $(LMB_CFLAGS) $(CFLAGS) $(filter %.c,$^) -o $@

$(B)/profile/plugin.so: $(PROFILE)/plugin.c $(PROFILER) $(PROFILE_HEADERS)
	@mkdir -p $(@D)
	$(Q)$(profile_build) -fPIC -shared -fvisibility=hidden

$(B)/profile/avr: $(PROFILE)/avr.c $(PROFILER) $(PROFILE_HEADERS)
	@mkdir -p $(@D)
	$(Q)$(profile_build) -lsimavr

$(B)/profile/feed: $(PROFILE)/feed.c $(PROFILER) $(PROFILE_HEADERS)
	@mkdir -p $(@D)
	$(Q)$(profile_build)

$(B)/profile/report: $(PROFILE)/report.c $(PROFILE)/program.c $(PROFILE_HEADERS)
	@mkdir -p $(@D)
	$(Q)$(profile_build)

# ------------------------------------------------------------------------------------------------------------- images and runs

define profile_rules
$(call profile_objects,$1): private SPECIAL = $$(call profile_flags,$1)
$(call profile_objects,$1): $(PROFILE)/profile.mk

$(B)/profile/$1/frames.elf: private SELECT = -DSELECT_PARTS=1
$(B)/profile/$1/kernels.elf: private SELECT = -DSELECT_PARTS=2
$(B)/profile/$1/methods.elf: private SELECT = -DSELECT_PARTS=12
$(B)/profile/$1/sweep.elf: private SELECT = -DSELECT_PARTS=16
$(B)/profile/$1/chosen.elf: private SELECT = -DSELECT_SCENE='"$$(SCENE)"' -DSELECT_MODEL='"$$(MODEL)"' \
    $(if $($1.profile_split),-DSELECT_PARTS=$$(if $$(filter kernels,$$(SCENE)),$$(if $$(filter lobe% step-%,$$(MODEL)),12,2),1))
$(B)/profile/$1/chosen.elf: always
$(B)/profile/$1/%.elf: $(PROFILE)/select.c port/demo/scenes.c $(call profile_objects,$1) \
    $(filter-out %/scenes.o,$($1.support)) $(B)/firmware/$1/liblambent.a $(call profile_ld,$1)
	@mkdir -p $$(@D)
	$$(Q)$$($1.compile) $$(CFLAGS) $$(SELECT) $$(call profile_flags,$1) $$(filter %.c %.o %.a,$$^) -o $$@ \
	    $$(call profile_link,$1) $$(call profile_libm,$1) $$(LDFLAGS) -lgcc
	$$(Q)$$(call profile_listing,$1,$$(basename $$@))

$(B)/profile/$1/test.elf: $(call profile_tests,$1) $(filter-out %/scenes.o $(B)/firmware/$1/meshes/%,$($1.support)) \
    $(call profile_ld,$1)
	@mkdir -p $$(@D)
	$$(Q)$$($1.compile) $$(CFLAGS) $$(filter %.o,$$^) -o $$@ $$(call profile_link,$1) $$(LDFLAGS) -lgcc
	$$(Q)$$(call profile_listing,$1,$$(basename $$@))

$(B)/profile/$1/%.out: $(B)/profile/$1/%.elf $(B)/profile/$(if $(filter avr-,$($1.prefix)),avr,plugin.so)
	$$(Q)rm -f $$@
	$$(Q)$$(call profile_execute,$1,$$(abspath $$(basename $$@)))

$(B)/profile/$1/growth.elf: $(PROFILE)/growth.c $(PROFILE)/growth.h port/demo/scenes.c $(B)/firmware/$1/$(PROFILE)/mark.o \
    $(GROWTH:%=$(B)/firmware/$1/meshes/icosphere_%.o) $(filter-out %/scenes.o,$($1.support)) $(B)/firmware/$1/liblambent.a \
    $(call profile_ld,$1)
	@mkdir -p $$(@D)
	$$(Q)$$($1.compile) $$(CFLAGS) -DSCENES=SCENE_WITH_ICOSPHERE_320 $$(filter %.c %.o %.a,$$^) -o $$@ \
	    $$(call profile_link,$1) $$(LDFLAGS) -lgcc
	$$(Q)$$(call profile_listing,$1,$$(basename $$@))

.PHONY: profile-$1
profile-$1: $(B)/profile/report $(B)/profile/$1/chosen.out
	$$(Q)$$< table $(B)/profile/$1/chosen.out $$(if $$(LIST),$$(LIST) $(B)/profile/$1/chosen.lst)
endef
.PHONY: always profile-help
$(foreach t,$(PROFILED),$(eval $(call profile_rules,$t)))

# profile_parts TARGET,PARTS: what the profiler has written of them.
profile_parts = $(patsubst %,$(B)/profile/$1/%.out,$(if $($1.profile_split),$2,all))

$(B)/report/cycles.csv: $(B)/profile/report $(foreach t,$(PROFILED),$(call profile_parts,$t,frames))
	@mkdir -p $(@D)
	$(Q){ echo core,scene,model,format,triangles,pixels,instructions_per_pixel,cycles_per_pixel,cycles_min,cycles_max; \
	    for f in $(filter %.out,$^); do $< cycles $$f || exit 1; done; } > $@

$(B)/report/kernel_cycles.csv: $(B)/profile/report $(foreach t,$(PROFILED),$(call profile_parts,$t,kernels methods))
	@mkdir -p $(@D)
	$(Q){ echo core,kernel,unit,instructions,cycles; \
	    for f in $(filter %.out,$^); do $< kernels $$f || exit 1; done; } > $@

# How cost grows.
$(B)/report/growth.csv: $(B)/profile/report $(GROWING:%=$(B)/profile/%/growth.out)
	@mkdir -p $(@D)
	$(Q){ echo core,axis,value,model,vertices,triangles,drawn,spans,pixels,strips,instructions,cycles; \
	    for t in $(GROWING); do $< growth $(B)/profile/$$t/growth.out || exit 1; done; } > $@

profile-help:
	@echo 'make profile TARGET=... [SCENE=...] [MODEL=...] [LIST=function] [MULTIPLIER=32]'
	@echo '  TARGET      $(PROFILED)'
	@echo '  SCENE       icosphere-320 icosphere-1280 icosphere-128 torus teapot kernels; all if left out (atmega1284p: kernels apart, lobe... and step-... by MODEL)'
	@echo '  MODEL       flat gouraud diffuse gloss gloss-arc, a method of comparison, or of kernels a kernel; all if left out'
	@echo '  LIST        prints the instructions of a function too, each with how often it was executed and its cycles'
	@echo '  MULTIPLIER  32: the small multiplier that makers of Cortex-M0 and M0+ may choose'
	@false

ifneq ($(filter profile,$(MAKECMDGOALS)),)
ifneq ($(filter-out $(PROFILED),$(TARGET)),)
$(error cannot profile TARGET=$(TARGET); known: $(PROFILED))
endif
endif
