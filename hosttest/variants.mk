# SPDX-License-Identifier: MIT
# Other compilers, optimisations and byte orders that must draw the very frames that the targets draw; read by the Makefile.

# variant NAME,TARGET: a block that begins as the target's own. Lines after it change what differs.
block-fields := cc prefix flags calls board sources ld link strip scenes without run fault counter needs
variant = $(eval VARIANTS += $1)$(foreach v,$(block-fields),$\
    $(if $(filter undefined,$(origin $2.$v)),,$(eval $1.$v = $(value $2.$v))))

VARIANTS :=
host_compilers := gcc-O0 gcc-O2 gcc-Os gcc-O3 clang-O2 clang-O3
$(foreach v,$(host_compilers),$(call variant,host-$v,host)$(eval host-$v.cc := $(firstword $(subst -, ,$v)))$\
    $(eval host-$v.flags := -$(lastword $(subst -, ,$v))))

$(call variant,host-m32,host)
host-m32.cc := gcc -m32 -fno-pie -no-pie

$(call variant,host-big-endian,host)
host-big-endian.cc := powerpc-linux-gnu-gcc -static
host-big-endian.prefix := powerpc-linux-gnu-
host-big-endian.run = qemu-ppc $(1)

$(foreach t,m0plus m4 m55 rv32imc lx106,$(foreach o,-Os -O3,$(call variant,$t$o,$t)$(eval $t$o.flags += $o)))

# Address spaces get lost in optimisers: tables in flash at another level. With one loop for all, code leaves room for larger meshes.
$(foreach o,-Os -O2,$(call variant,atmega1284p$o,atmega1284p)$(eval atmega1284p$o.flags += $o -ULMB_LOOPS -DLMB_LOOPS=0 -mrelax))
atmega1284p-Os.scenes := torus teapot
atmega1284p-Os.without := the image with all loops draws spheres
atmega1284p-O2.scenes := icosphere-128
atmega1284p-O2.without := the images at -Os draw them

# Another compiler for the boards; GNU ld and libgcc all the same.
clang-link = --ld-path=arm-none-eabi-ld -Wl,-z,noexecstack $(filter-out -nostartfiles -lgcc,$(call BARE_LINK,$1)) \
    $(shell arm-none-eabi-gcc $($1.flags) -print-libgcc-file-name)
$(foreach t,m0plus m4,$(call variant,$t-clang,$t)$\
    $(eval $t-clang.cc := clang --target=arm-none-eabi -mfloat-abi=soft -fshort-enums)$\
    $(eval $t-clang.calls += __aeabi_mem*)$(eval $t-clang.link = $$(call clang-link,$t-clang)))

# The code of m3 in 8 KB of RAM.
$(call variant,m3-stm32vl,m3)
m3-stm32vl.ld := linker/stm32vldiscovery.ld
m3-stm32vl.strip := 4096
m3-stm32vl.run = $(call qemu-arm,stm32vldiscovery) $(1)

# What all are compared with: the host's frames, each drawn in one piece. Not compared with itself.
$(call variant,reference,host)
reference.strip := 307200
