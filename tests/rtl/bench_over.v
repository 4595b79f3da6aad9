// The stage over: a sample before what a ray has gathered, SPEC.md, sections 13 and 14.
`default_nettype none
`include "layout.vh"

module bench_over (
    output reg done
);
    localparam STAGE = "over";
    localparam ROWS = `over_ROWS;
    localparam BITS = `over_BITS;
`include "bench.vh"

    // Both storages' opacities come 2 clocks late, and with them the rest of the row.
    wire [31:0]  o = row[`over_o];
    wire [31:0]  a32_8, a32_16, a32, transmittance;
    wire [223:0] rest;
    wire [95:0]  colours;
    wire         wide;

    opacity #(.BITS(8)) widen8 (clock, o[23:0], a32_8);
    opacity #(.BITS(16)) widen16 (clock, o, a32_16);
    delay #(.WIDTH(225), .CLOCKS(2)) delay_rest (clock, {row[`over_wide_top-3], row[`over_l2],
        row[`over_l1], row[`over_l0], row[`over_e2], row[`over_e1], row[`over_e0], row[`over_t]},
        {wide, rest});
    assign a32 = wide ? a32_16 : a32_8;
    over unit (clock, rest[32 +: 96], rest[0 +: 32], rest[128 +: 96], a32, colours, transmittance);

    always @(negedge clock) if (!done) begin
        edges = edges + 1;
        `EXPECT(2, "a32", -1, `over_a32, a32);
        `EXPECT(3, "lost", -1, `over_lost, unit.lost);
        for (i = 0; i < 3; i = i + 1) begin
            `EXPECT(3, "part", i, `over_part0_top - 32 * i -: 32, unit.hidden[32*i +: 32]);
            `EXPECT(3, "half", i, `over_half0_top - 32 * i -: 32, unit.half1[32*i +: 32]);
            `EXPECT(5, "en", i, `over_en0_top - 32 * i -: 32, colours[32*i +: 32]);
        end
        `EXPECT(5, "tn", -1, `over_tn, transmittance);
        finish_after(5);
    end
endmodule
