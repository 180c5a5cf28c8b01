/* SPDX-License-Identifier: MIT */
/* Feeds the profiler with a stream of addresses from a file, in hexadecimal, one instruction a line; a second number is its
 * cycles. So streams can be looked at, and doctored by tests.
 *
 *   feed CORE LISTING STREAM OUT [told]
 */
#include "trace.h"

#include <inttypes.h>
#include <string.h>

int main(int argc, char **argv)
{
    static program image;
    trace_options o = {"", NULL, false, false, false};
    char line[80];
    trace *profile;
    FILE *stream;
    if (argc < 5) profile_fail("usage: feed CORE LISTING STREAM OUT [told]");
    o.core = argv[1];
    o.told = argc > 5 && !strcmp(argv[5], "told");
    program_read(&image, argv[2]);
    if (!(stream = fopen(argv[3], "r"))) profile_fail("cannot read %s", argv[3]);
    if (!(o.out = fopen(argv[4], "w"))) profile_fail("cannot write %s", argv[4]);
    profile = trace_new(&image, &o);
    while (fgets(line, sizeof line, stream)) {
        const instruction *i;
        uint32_t address;
        int cost = 0;
        if (sscanf(line, "%" SCNx32 " %d", &address, &cost) < 1) profile_fail("cannot read: %s", line);
        i = program_at(&image, address);
        trace_run(profile, i ? trace_block(profile, i, 1) : NULL, cost);
    }
    fclose(stream);
    return trace_end(profile) ? 0 : 1;
}
