// The stages sample8 and sample16: opacity-weighted interpolation, SPEC.md, sections 12 and 13.
`default_nettype none
`include "layout.vh"

module bench_sample #(
    parameter WIDE = 0, // 1: 16 bits
    parameter STAGE = "sample8"
) (
    output reg done
);
    localparam ROWS = WIDE ? `sample16_ROWS : `sample8_ROWS;
    localparam BITS = WIDE ? `sample16_BITS : `sample8_BITS;
    localparam V = WIDE ? 16 : 8; // bits of a voxel's channel
    localparam F = WIDE ? `sample16_f0_top : `sample8_f0_top;
    localparam R = WIDE ? `sample16_r0_top : `sample8_r0_top;
    localparam G = WIDE ? `sample16_g0_top : `sample8_g0_top;
    localparam B = WIDE ? `sample16_b0_top : `sample8_b0_top;
    localparam A = WIDE ? `sample16_a0_top : `sample8_a0_top;
    localparam W = WIDE ? `sample16_w0_top : `sample8_w0_top;
    localparam S = WIDE ? `sample16_s0_top : `sample8_s0_top;
    localparam TR = WIDE ? `sample16_tr0_top : `sample8_tr0_top;
    localparam TG = WIDE ? `sample16_tg0_top : `sample8_tg0_top;
    localparam TB = WIDE ? `sample16_tb0_top : `sample8_tb0_top;
    localparam SKIPPED = WIDE ? `sample16_skipped_top : `sample8_skipped_top;
    localparam O = WIDE ? `sample16_o_top : `sample8_o_top;
    localparam L = WIDE ? `sample16_l0_top : `sample8_l0_top;
    localparam A32 = WIDE ? `sample16_a32_top : `sample8_a32_top;
`include "bench.vh"

    wire [8*V-1:0]  opacities;
    wire [24*V-1:0] colours;
    wire [V+15:0]   o;
    wire [95:0]     lights;
    wire [31:0]     a32;
    wire            skipped;
    genvar          q;

    generate
        for (q = 0; q < 8; q = q + 1) begin : corner
            assign opacities[V*q +: V] = row[A-V*q -: V];
            assign colours[V*q +: V] = row[R-V*q -: V];
            assign colours[V*(8+q) +: V] = row[G-V*q -: V];
            assign colours[V*(16+q) +: V] = row[B-V*q -: V];
        end
    endgenerate
    interpolate #(.BITS(V)) unit (clock, row[F -: 8], row[F-8 -: 8], row[F-16 -: 8], opacities,
        colours, o, lights, skipped);
    opacity #(.BITS(V)) widen (clock, o, a32);

    always @(negedge clock) if (!done) begin
        edges = edges + 1;
        for (i = 0; i < 8; i = i + 1) begin
            `EXPECT(4, "w", i, W - 20 * i -: 20, unit.w[17*i +: 17]);
            `EXPECT(5, "s", i, S - 32 * i -: 32, unit.s[(V+16)*i +: V+16]);
            `EXPECT(6, "tr", i, TR - 32 * i -: 32, unit.terms[32*i +: 32]);
            `EXPECT(6, "tg", i, TG - 32 * i -: 32, unit.terms[32*(8+i) +: 32]);
            `EXPECT(6, "tb", i, TB - 32 * i -: 32, unit.terms[32*(16+i) +: 32]);
        end
        for (i = 0; i < 3; i = i + 1) `EXPECT(9, "l", i, L - 32 * i -: 32, lights[32*i +: 32]);
        `EXPECT(9, "o", -1, O -: 32, o);
        `EXPECT(9, "skipped", -1, SKIPPED -: 4, skipped);
        `EXPECT(11, "a32", -1, A32 -: 32, a32);
        finish_after(11);
    end
endmodule
