// The stage weights: tests/vectors/weights.hex, SPEC.md, section 11.
`default_nettype none
`include "layout.vh"

module bench_weights (
    output reg done
);
    localparam STAGE = "weights";
    localparam ROWS = `weights_ROWS;
    localparam BITS = `weights_BITS;
`include "bench.vh"

    wire [8*17-1:0] w;

    weights unit (clock, row[`weights_f0], row[`weights_f1], row[`weights_f2], w);

    always @(negedge clock) if (!done) begin
        edges = edges + 1;
        `EXPECT(1, "xy", -1, `weights_xy, unit.xy);
        `EXPECT(1, "xz", -1, `weights_xz, unit.xz);
        `EXPECT(1, "yz", -1, `weights_yz, unit.yz);
        `EXPECT(2, "xyz", -1, `weights_xyz, unit.xyz);
        for (i = 0; i < 8; i = i + 1)
            `EXPECT(4, "w", i, `weights_w0_top - 20 * i -: 20, w[17*i +: 17]);
        finish_after(4);
    end
endmodule
