# SPDX-License-Identifier: MIT
# Speed against accuracy: build/report/pareto.csv, and what it is made from; read by the Makefile. make pareto

PARETO := hosttest/pareto
PARETO_CORES := m0plus m4 rv32imc atmega1284p

# What frames cost, ours and, where memory holds whole frames, those of the comparisons.
define pareto_rules
$(B)/pareto/$1/frames.csv: $(B)/profile/report $(B)/profile/$1/sweep.out $(if $($1.profile_split),,$(B)/profile/$1/all.out)
	@mkdir -p $$(@D)
	$$(Q)for f in $$(filter %.out,$$^); do $$< frames $$$$f $$$${f%.out}.lst || exit 1; done > $$@

$(B)/pareto/$1/bytes.csv: $(PARETO)/bytes.sh hosttest/size.ld $(patsubst %.c,$(B)/firmware/$1/%.o,$(wildcard hosttest/compare/*.c)) \
    $(B)/firmware/$1/port/demo/memory.o $(B)/firmware/$1/liblambent.a
	@mkdir -p $$(@D)
	$$(Q)$$< $1 "$($1.prefix)" "$($1.flags)" $(B)/firmware/$1/hosttest/compare $$(filter %memory.o %.a,$$^) $(call profile_libm,$1) > $$@
endef
$(foreach t,$(PARETO_CORES),$(eval $(call pareto_rules,$t)))

# Frames of the comparisons that tell what they round, for the host.
$(B)/pareto/%.o: hosttest/%.c
	@mkdir -p $(@D)
	$(Q)$(COMPILE) -DCOMPARE_TAPPED -c $< -o $@
$(B)/hosttest/pareto/rivals.o: private CPPFLAGS += -DCOMPARE_TAPPED

PARETO_OBJECTS := $(patsubst %.c,$(B)/%.o,$(wildcard $(PARETO)/*.c)) $(patsubst hosttest/%.c,$(B)/pareto/%.o,$(wildcard hosttest/compare/*.c))
$(B)/bin/pareto: $(PARETO_OBJECTS) $(filter $(B)/hosttest/papers/%,$(PAPERS)) $(SCENES) $(REFERENCE) $(B)/liblambent.a
	@mkdir -p $(@D)
	$(Q)$(LINK)

$(B)/bin/test_pareto_frames: $(B)/hosttest/pareto/frames.o $(B)/hosttest/pareto/methods.o \
    $(PAPERS) $(SCENES) $(REFERENCE)

PARETO_COSTS := $(foreach c,frames bytes,$(PARETO_CORES:%=$(B)/pareto/%/$c.csv))
$(B)/report/pareto.csv: $(B)/bin/pareto $(B)/report/kernel_cycles.csv $(PARETO_COSTS)
	@mkdir -p $(@D)
	@echo $@
	$(Q)$< $(B)/report/kernel_cycles.csv $(PARETO_COSTS) > $@
