# SPDX-License-Identifier: MIT
# The targets: one block each, read by the Makefile. docs/PORTING.md shows how to add one.
#
#   NAME.cc       compiler; default: $(NAME.prefix)gcc
#   NAME.prefix   of the binutils, and of gcc
#   NAME.flags    what the core needs, for compiler and linker
#   NAME.board    folder in port/ with start-up and board functions: all of its .c and .S files (NAME.sources: these instead)
#   NAME.ld       memory map
#   NAME.link     how to link; default: by NAME.ld alone, nothing from the compiler but libgcc
#   NAME.calls    the compiler's own helpers that objects may call, for the gate; none by default
#   NAME.strip    bytes of RAM for a strip of pixels and their depth
#   NAME.scenes   all, or those that fit; then NAME.without says why the others do not
#   NAME.run      command that runs the image $(1) in the folder that takes its files; written with =, not :=
#   NAME.fault    exit status that a fault has; none where the core knows no faults
#   NAME.counter  none where lmb_board_cycles has nothing to count with
#   NAME.needs    what that command needs built, if anything: a simulator of our own
#
# The core of all names: m0plus and cortex-m0plus are the same to make.

TARGETS := host

host.cc      = $(CC)
host.flags  :=
host.board  := host
host.sources := port/host/board.c
host.link   := -lm
host.strip  := 32768
host.scenes := all
host.run     = $(1)

qemu-arm = qemu-system-arm -display none -monitor none -serial none -chardev stdio,id=console \
    -semihosting-config enable=on,target=native,chardev=console -machine $(1) -kernel

# A core without 64-bit products and with one-bit carries calls for these.
calls-v6m := __aeabi_lmul __aeabi_llsl __aeabi_llsr __aeabi_lasr __gnu_thumb1_case_*

# Cortex-M0+ has no emulated board: its code runs on the Cortex-M0 of the micro:bit, in 16 KB of RAM.
TARGETS += m0plus
m0plus.prefix := arm-none-eabi-
m0plus.flags  := -mcpu=cortex-m0plus -mthumb
m0plus.calls  := $(calls-v6m)
m0plus.board  := cortex-m
m0plus.ld     := linker/microbit.ld
m0plus.strip  := 10240
m0plus.scenes := all
m0plus.fault  := 67
m0plus.run     = $(call qemu-arm,microbit) $(1)

TARGETS += m0
m0.prefix := arm-none-eabi-
m0.flags  := -mcpu=cortex-m0 -mthumb
m0.calls  := $(calls-v6m)
m0.board  := cortex-m
m0.ld     := linker/microbit.ld
m0.strip  := 10240
m0.scenes := all
m0.fault  := 67
m0.run     = $(call qemu-arm,microbit) $(1)

TARGETS += m3
m3.prefix := arm-none-eabi-
m3.flags  := -mcpu=cortex-m3 -mthumb
m3.board  := cortex-m
m3.ld     := linker/mps2-an385.ld
m3.strip  := 32768
m3.scenes := all
m3.fault  := 67
m3.run     = $(call qemu-arm,mps2-an385) $(1)

TARGETS += m4
m4.prefix := arm-none-eabi-
m4.flags  := -mcpu=cortex-m4 -mthumb -mfloat-abi=soft
m4.board  := cortex-m
m4.ld     := linker/mps2-an385.ld
m4.strip  := 32768
m4.scenes := all
m4.fault  := 67
m4.run     = $(call qemu-arm,mps2-an386) $(1)

TARGETS += m33
m33.prefix := arm-none-eabi-
m33.flags  := -mcpu=cortex-m33 -mthumb -mfloat-abi=soft
m33.board  := cortex-m
m33.ld     := linker/mps2-an505.ld
m33.strip  := 32768
m33.scenes := all
m33.fault  := 67
m33.run     = $(call qemu-arm,mps2-an505) $(1)

# With Helium: gcc -O3 uses it for loops over integers.
TARGETS += m55
m55.prefix := arm-none-eabi-
m55.flags  := -mcpu=cortex-m55 -mthumb -mfloat-abi=hard
m55.board  := cortex-m
m55.ld     := linker/mps3-an547.ld
m55.strip  := 32768
m55.scenes := all
m55.fault  := 67
m55.run     = $(call qemu-arm,mps3-an547) $(1)

qemu-riscv32 = qemu-system-riscv32 -bios none -display none -monitor none -serial none -chardev stdio,id=console \
    -semihosting-config enable=on,target=native,chardev=console -machine virt

# The emulated cores have the extensions of -march and no others. ISA 2.2 has the instructions for mcycle and mcause in its base;
# with _zicsr in -march gcc 12 would take the libgcc of 64-bit cores.
TARGETS += rv32imc
rv32imc.prefix := riscv64-unknown-elf-
rv32imc.flags  := -march=rv32imc -mabi=ilp32 -misa-spec=2.2 -mcmodel=medany
rv32imc.board  := rv32
rv32imc.ld     := linker/rv32-virt.ld
rv32imc.calls  := __ashldi3 __ashrdi3 __lshrdi3
rv32imc.strip  := 16384
rv32imc.scenes := all
rv32imc.fault  := 67
rv32imc.run     = $(qemu-riscv32) -cpu rv32,a=off,f=off,d=off,h=off -kernel $(1)

# No multiplier: products are loops in libgcc.
TARGETS += rv32i
rv32i.prefix := riscv64-unknown-elf-
rv32i.flags  := -march=rv32i -mabi=ilp32 -misa-spec=2.2 -mcmodel=medany
rv32i.board  := rv32
rv32i.ld     := linker/rv32-virt.ld
rv32i.calls  := __mulsi3 __muldi3 __ashldi3 __ashrdi3 __lshrdi3
rv32i.strip  := 16384
rv32i.scenes := all
rv32i.fault  := 67
rv32i.run     = $(qemu-riscv32) -cpu rv32,m=off,a=off,f=off,d=off,c=off,h=off -kernel $(1)

# Sixteen registers and no multiplier, as in the CH32V003.
TARGETS += rv32ec
rv32ec.prefix := riscv64-unknown-elf-
rv32ec.flags  := -march=rv32ec -mabi=ilp32e -misa-spec=2.2 -mcmodel=medany
rv32ec.board  := rv32
rv32ec.ld     := linker/rv32-virt.ld
rv32ec.calls  := __mulsi3 __muldi3 __ashldi3 __ashrdi3 __lshrdi3
rv32ec.strip  := 16384
rv32ec.scenes := all
rv32ec.fault  := 67
rv32ec.run     = $(qemu-riscv32) -cpu rv32,i=off,e=on,m=off,a=off,f=off,d=off,h=off -kernel $(1)

# The core of the ESP8266.
TARGETS += lx106
lx106.prefix := xtensa-lx106-elf-
lx106.flags  := -mtext-section-literals -DLMB_LONG_PRODUCTS=0
lx106.board  := xtensa
lx106.ld     := linker/lx106-sim.ld
lx106.calls  := __muldi3 __ashldi3 __ashrdi3 __lshrdi3
lx106.strip  := 32768
lx106.scenes := all
lx106.fault  := 64
lx106.run     = qemu-system-xtensa -display none -monitor none -serial none -semihosting -machine sim -cpu lx106 -kernel $(1)

# LMB_FLASH is __flash there, which c99 does not know; a table in flash that is read as if it were in RAM is an error.
avr-flags = -std=gnu99 -mmcu=$(1) -Werror=addr-space-convert
# Products, and on numbers of 64 bits shifts, sums and comparisons.
avr-calls := __mulhisi3 __umulhisi3 __usmulhisi3 __muluhisi3 __mulshisi3 __mulsi3 __mulsidi3 __umulsidi3 __muldi3 \
    __ashldi3 __ashrdi3 __lshrdi3 __adddi3 __adddi3_s8 __subdi3 __negdi2 __cmpdi2 __cmpdi2_s8

TARGETS += atmega1284p
atmega1284p.prefix := avr-
# At -O2 library and meshes are more than 128 KB.
atmega1284p.flags  := $(call avr-flags,atmega1284p) -Os -DLMB_LOOPS=1
atmega1284p.board  := avr
atmega1284p.ld     := linker/atmega1284p.ld
atmega1284p.calls  := $(avr-calls)
atmega1284p.strip  := 9600
atmega1284p.scenes := icosphere-128 icosphere-320 icosphere-320-tight icosphere-1280
atmega1284p.without := torus and teapot are drawn by atmega1284p-Os, which has fewer loops; still-life needs over 64 KB of tables
atmega1284p.needs  := $(B)/bin/avr-run
atmega1284p.fault  := 64
atmega1284p.run     = $(abspath $(B)/bin/avr-run) atmega1284p $(1)

# In 2 KB of RAM, two rows at a time, with what the scene does not need left out. icosphere-320 fits as well, row by row, but
# takes long to simulate.
TARGETS += atmega328p
atmega328p.prefix := avr-
atmega328p.flags  := $(call avr-flags,atmega328p) -Os -mcall-prologues -DLMB_LIGHTS=1 \
    $(patsubst %,-DLMB_WITH_%=0,ARC CORNERS PERSPECTIVE DEPTH LARGE LOBES RAMPS RGB888)
atmega328p.board  := avr
atmega328p.ld     := linker/atmega328p.ld
atmega328p.calls  := $(avr-calls) __prologue_saves__ __epilogue_restores__
atmega328p.strip  := 512
atmega328p.scenes := icosphere-128
atmega328p.without := 32 KB of flash hold the smallest mesh alone
atmega328p.needs  := $(B)/bin/avr-run
atmega328p.fault  := 64
atmega328p.run     = $(abspath $(B)/bin/avr-run) atmega328p $(1)
