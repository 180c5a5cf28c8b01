# SPDX-License-Identifier: MIT
# lmb-estimate: the counted library, the frames that costs are fitted on and judged by, and the fit; read by the Makefile.
#
# A list (hosttest/estimate/LIST.txt) has a frame a line. build/profile/TARGET/LIST.elf draws them all, the profiler measures them,
# build/estimate/LIST-TARGET.csv holds what each stage took.

ESTIMATE := hosttest/estimate
ESTIMATE_LISTS := training held-out $(if $(FRAMES),given)
estimate_list = $(if $(filter given,$1),$(FRAMES),$(if $(filter training,$1),$(B)/estimate/training.txt,$(ESTIMATE)/$1.txt))
ESTIMATE_CORES := m0plus m0 m3 m4 rv32imc

# The library with calls between its files counted: FILE defines these inside_..., and port/host/count_calls.c what others call.
COUNTED := triangle shade plane plane_exact edge stride edge_arc curve arc clip screen fill
counted.triangle := lmb_triangle_seen lmb_triangle_front lmb_triangle_next
counted.shade := lmb_shade_begin
counted.plane := lmb_plane_begin lmb_plane_down
counted.plane_exact := lmb_plane_exact
counted.edge := lmb_edge_begin
counted.stride := lmb_strides_begin lmb_strides_turn
counted.edge_arc := lmb_edge_arc_begin lmb_edge_arc_step lmb_edge_arc_span
counted.curve := lmb_run_rough
counted.arc := lmb_arc_prepare lmb_arc_start
counted.clip := lmb_clip
counted.screen := lmb_screen_project lmb_screen_y
counted.fill := lmb_fill_span

# As cores run it: compiled for speed, whatever else is.
$(B)/counted/%.o: %.c $(ESTIMATE)/estimate.mk
	@mkdir -p $(@D)
	$(Q)$(COMPILE) -O2 -DLMB_LOOPS=1 $(INTEGER_CFLAGS) $(foreach f,$(counted.$(notdir $*)),-D$f=inside_$f) -c $< -o $@

$(B)/counted/liblambent.a: $(patsubst %.c,$(B)/counted/%.o,$(FIRMWARE) $(PORT)) $(B)/hosttest/checked.o
	$(Q)rm -f $@ && $(AR) rcs $@ $^

ESTIMATING := $(addprefix $(B)/port/host/,estimate.o view.o count.o count_calls.o costs.o)
$(B)/bin/lmb-estimate: $(B)/port/host/lmb_estimate.o $(B)/port/host/cost_cores.o $(B)/port/host/flash.o
$(B)/bin/lmb-estimate: $(ESTIMATING) $(OBJ) $(B)/counted/liblambent.a
	@mkdir -p $(@D)
	$(Q)$(LINK)

# ------------------------------------------------------------------------------------------------------------------- models

$(B)/bin/estimate_models: $(B)/$(ESTIMATE)/models.o
$(B)/bin/estimate_frames: $(B)/$(ESTIMATE)/frames.o
$(B)/bin/estimate_cases: $(B)/$(ESTIMATE)/cases.o
$(B)/bin/estimate_fit: $(B)/$(ESTIMATE)/fit.o $(B)/$(ESTIMATE)/squares.o $(B)/$(ESTIMATE)/measured.o
$(B)/bin/estimate_judge: $(B)/$(ESTIMATE)/judge.o $(B)/$(ESTIMATE)/measured.o $(B)/port/host/cost_cores.o
$(patsubst %,$(B)/bin/estimate_%,cases fit judge): $(B)/$(ESTIMATE)/list.o $(ESTIMATING) $(OBJ) $(B)/counted/liblambent.a
$(patsubst %,$(B)/bin/estimate_%,models frames cases fit judge):
	@mkdir -p $(@D)
	$(Q)$(LINK)

# Those that a list names, each with its mesh: models of the demo and of estimate_models.
estimate_words = $(if $(filter training,$1),$(ESTIMATE_TRAINING),$(shell sed 's/^\#.*//; s/ .*//' $(call estimate_list,$1) | sort -u))
ESTIMATE_TRAINING := icosphere_20 icosphere_80 icosphere_320 icosphere_1280 icosphere_5120 globe bead gem ring hoop waves rod reed \
    crystal blocks sheet coil cups brick crate fence
ESTIMATE_FRAMES := 1872
ESTIMATE_MODELS := $(sort $(foreach l,$(ESTIMATE_LISTS),$(call estimate_words,$l)))
estimate_meshes = $(patsubst %,meshes/estimate_%.o,$(call estimate_words,$1))
estimate_models = $(patsubst %,$(B)/estimate/models/%.obj,$(call estimate_words,$1))

# MODELS: a folder of yours, where it has a model.
estimate_made := $(filter-out teapot torus $(SPHERES:%=icosphere_%),$(ESTIMATE_MODELS))
estimate_yours := $(if $(MODELS),$(foreach m,$(estimate_made),$(if $(wildcard $(MODELS)/$m.obj),$m)))
$(patsubst %,$(B)/estimate/models/%.obj,$(estimate_yours)): $(B)/estimate/models/%.obj: $(MODELS)/%.obj
	@mkdir -p $(@D)
	$(Q)cp $< $@
$(patsubst %,$(B)/estimate/models/%.obj,$(filter-out $(estimate_yours),$(estimate_made))): $(B)/estimate/models/%.obj: $(B)/bin/estimate_models
	@mkdir -p $(@D)
	$(Q)$< $* $@
$(B)/estimate/models/teapot.obj $(B)/estimate/models/torus.obj: $(B)/estimate/models/%.obj: $(B)/models/%.obj
	@mkdir -p $(@D)
	$(Q)cp $< $@
$(SPHERES:%=$(B)/estimate/models/icosphere_%.obj): $(B)/estimate/models/icosphere_%.obj: $(B)/gen/gen_icosphere
	@mkdir -p $(@D)
	$(Q)$< $(sphere.$*) icosphere $@

$(ESTIMATE_MODELS:%=$(B)/meshes/estimate_%.c): $(B)/meshes/estimate_%.c: $(B)/estimate/models/%.obj $(B)/bin/lmb-mesh
	@mkdir -p $(@D)
	$(Q)$(B)/bin/lmb-mesh $< --fit --name mesh_$* -q -o $@

# ------------------------------------------------------------------------------------------------------------- measured frames

$(B)/estimate/training.txt: $(B)/bin/estimate_frames
	@mkdir -p $(@D)
	$(Q)$< training $(ESTIMATE_FRAMES) 1 > $@

define estimate_list_rules
$(B)/estimate/$1.h: $(call estimate_list,$1) $(B)/bin/estimate_cases $(call estimate_models,$1)
	$$(Q)$(B)/bin/estimate_cases $$< $(B)/estimate/models > $$@
endef
$(foreach l,$(ESTIMATE_LISTS),$(eval $(call estimate_list_rules,$l)))

# estimate_rules TARGET,LIST
define estimate_rules
$(B)/profile/$1/$2.elf: $(ESTIMATE)/draw.c $(ESTIMATE)/case.h $(B)/estimate/$2.h $(B)/firmware/$1/$(PROFILE)/mark.o \
    $(addprefix $(B)/firmware/$1/,$(call estimate_meshes,$2)) $(filter-out %/scenes.o $(B)/firmware/$1/meshes/%,$($1.support)) \
    $(B)/firmware/$1/liblambent.a $(call profile_ld,$1)
	@mkdir -p $$(@D)
	$$(Q)$$($1.compile) $$(CFLAGS) -DESTIMATE_CASES='"$$(abspath $(B)/estimate/$2.h)"' $$(filter %.c %.o %.a,$$^) -o $$@ \
	    $$(call profile_link,$1) $$(LDFLAGS) -lgcc
	$$(Q)$$(call profile_listing,$1,$$(basename $$@))

$(B)/estimate/$2-$1.csv: $(B)/profile/report $(B)/profile/$1/$2.out
	@mkdir -p $$(@D)
	$$(Q){ echo core,case,drawn,instructions,cycles,project,sort,begin,walk,shade,fill; $$< stages $(B)/profile/$1/$2.out; } > $$@
endef
$(foreach t,$(ESTIMATE_CORES),$(foreach l,$(ESTIMATE_LISTS),$(eval $(call estimate_rules,$t,$l))))

# --------------------------------------------------------------------------------------------------------------- fit and verdict

estimate_measured = $(foreach t,$(or $(TARGET),$(ESTIMATE_CORES)),$(B)/estimate/$1-$t.csv)

ESTIMATE_WEIGHED := empty $(addprefix draw+,flat gouraud diffuse gloss arc planned $(addprefix gloss+,depth perspective rgb888 lights painter))
estimate_images = $(foreach o,Os O2,$(foreach c,$(ESTIMATE_WEIGHED),$(B)/size/$1/$c-$o/whole.elf))

$(B)/estimate/flash_table.h: $(ESTIMATE)/flash.sh hosttest/size.sh $(foreach t,$(ESTIMATE_CORES),$(call estimate_images,$t))
	@mkdir -p $(@D)
	$(Q)$< $(B)/size $(foreach t,$(ESTIMATE_CORES),$t=$($t.prefix)) > $@

# Two images stand for all in make check.
estimate_sampled := draw+gloss-O2 draw+planned-Os
.PHONY: estimate_flash
estimate_flash: hosttest/size.sh $(patsubst %,$(B)/size/m0plus/%/whole.elf,empty-O2 empty-Os $(estimate_sampled))
	$(Q)$(ESTIMATE)/flash.sh check $(B)/size m0plus=$(m0plus.prefix) $(estimate_sampled)

.PHONY: costs estimate
costs: $(B)/estimate/flash_table.h $(B)/bin/estimate_fit $(foreach t,$(ESTIMATE_CORES),$(B)/estimate/training-$t.csv)
	$(Q)$(B)/bin/estimate_fit $(B)/estimate/training.txt $(B)/estimate/models $(filter %.csv,$^) > $(B)/estimate/costs_table.h
	$(Q)cp $(B)/estimate/costs_table.h $(B)/estimate/flash_table.h port/host

estimate_judged := $(if $(FRAMES),given,held-out)
estimate: $(B)/bin/estimate_judge $(call estimate_measured,$(estimate_judged))
	$(Q)$< verdicts $(call estimate_list,$(estimate_judged)) $(B)/estimate/models $(filter %.csv,$^)

$(B)/report/estimate.csv: $(B)/bin/estimate_judge $(foreach t,$(ESTIMATE_CORES),$(B)/estimate/held-out-$t.csv)
	@mkdir -p $(@D)
	$(Q)$< csv $(ESTIMATE)/held-out.txt $(B)/estimate/models $(filter %.csv,$^) > $@

# Beside growth.csv: what is estimated of the same frames.
$(B)/bin/growth_model: $(B)/$(ESTIMATE)/growth_model.o $(ESTIMATING) $(B)/port/host/cost_cores.o $(OBJ) $(SCENES) \
    $(GROWTH:%=$(B)/meshes/icosphere_%.o) $(B)/counted/liblambent.a
	@mkdir -p $(@D)
	$(Q)$(LINK)

$(B)/report/growth_model.csv: $(B)/bin/growth_model
	@mkdir -p $(@D)
	$(Q)$< > $@

.PHONY: growth_tables
growth_tables: $(B)/bin/estimate_judge $(B)/report/estimate.csv
	$(Q)$(ESTIMATE)/growth.sh $< $(B)/report
