// The stages separate8 and separate16: colour and opacity apart, SPEC.md, sections 12 and 13.
`default_nettype none
`include "layout.vh"

module bench_separate #(
    parameter WIDE = 0, // 1: 16 bits
    parameter STAGE = "separate8"
) (
    output reg done
);
    localparam ROWS = WIDE ? `separate16_ROWS : `separate8_ROWS;
    localparam BITS = WIDE ? `separate16_BITS : `separate8_BITS;
    localparam V = WIDE ? 16 : 8; // bits of a voxel's channel
    localparam F = WIDE ? `separate16_f0_top : `separate8_f0_top;
    localparam R = WIDE ? `separate16_r0_top : `separate8_r0_top;
    localparam G = WIDE ? `separate16_g0_top : `separate8_g0_top;
    localparam B = WIDE ? `separate16_b0_top : `separate8_b0_top;
    localparam A = WIDE ? `separate16_a0_top : `separate8_a0_top;
    localparam W = WIDE ? `separate16_w0_top : `separate8_w0_top;
    localparam D = WIDE ? `separate16_d0_top : `separate8_d0_top;
    localparam SKIPPED = WIDE ? `separate16_skipped_top : `separate8_skipped_top;
    localparam O = WIDE ? `separate16_o_top : `separate8_o_top;
    localparam L = WIDE ? `separate16_l0_top : `separate8_l0_top;
    localparam A32 = WIDE ? `separate16_a32_top : `separate8_a32_top;
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
    separate #(.BITS(V)) unit (clock, row[F -: 8], row[F-8 -: 8], row[F-16 -: 8], opacities,
        colours, o, lights, skipped);
    opacity #(.BITS(V)) widen (clock, o, a32);

    always @(negedge clock) if (!done) begin
        edges = edges + 1;
        for (i = 0; i < 8; i = i + 1) `EXPECT(4, "w", i, W - 20 * i -: 20, unit.w[17*i +: 17]);
        for (i = 0; i < 3; i = i + 1) begin
            `EXPECT(8, "d", i, D - 32 * i -: 32, unit.sums[(V+16)*i +: V+16]);
            `EXPECT(9, "l", i, L - 32 * i -: 32, lights[32*i +: 32]);
        end
        `EXPECT(9, "o", -1, O -: 32, o);
        `EXPECT(9, "skipped", -1, SKIPPED -: 4, skipped);
        `EXPECT(11, "a32", -1, A32 -: 32, a32);
        finish_after(11);
    end
endmodule
