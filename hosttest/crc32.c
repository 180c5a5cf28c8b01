/* SPDX-License-Identifier: MIT */
/* Prints the CRC-32 of a file (ISO 3309; zip, PNG), from the definition: long division of the bits by the polynomial. Shares
 * nothing with port/demo/frames.c, which prints the same on the boards. */
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv)
{
    unsigned long remainder = 0xffffffff;
    FILE *file;
    int byte, bit;
    if (argc != 2) {
        fprintf(stderr, "usage: crc32 FILE\n");
        return 2;
    }
    file = fopen(argv[1], "rb");
    if (!file) {
        perror(argv[1]);
        return EXIT_FAILURE;
    }
    while ((byte = getc(file)) != EOF) {
        for (bit = 0; bit < 8; bit++) {
            unsigned long odd = (remainder ^ (unsigned long)(byte >> bit)) & 1;
            remainder = remainder >> 1 ^ (odd ? 0xedb88320 : 0);
        }
    }
    fclose(file);
    printf("%08lx\n", remainder ^ 0xffffffff);
    return EXIT_SUCCESS;
}
