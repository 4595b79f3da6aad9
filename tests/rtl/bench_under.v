// The stage under: a sample behind what a ray has gathered, SPEC.md, sections 13 to 15.
`default_nettype none
`include "layout.vh"

module bench_under (
    output reg done
);
    localparam STAGE = "under";
    localparam ROWS = `under_ROWS;
    localparam BITS = `under_BITS;
`include "bench.vh"

    // Both storages' opacities come 2 clocks late, and with them the rest of the row.
    wire [31:0]  o = row[`under_o];
    wire [31:0]  a32_8, a32_16, a32, transmittance;
    wire [239:0] rest;
    wire [95:0]  colours;
    wire         wide, ended;

    opacity #(.BITS(8)) widen8 (clock, o[23:0], a32_8);
    opacity #(.BITS(16)) widen16 (clock, o, a32_16);
    delay #(.WIDTH(241), .CLOCKS(2)) delay_rest (clock, {row[`under_wide_top-3],
        row[`under_l2], row[`under_l1], row[`under_l0], row[`under_e2], row[`under_e1],
        row[`under_e0], row[`under_t], row[`under_threshold]}, {wide, rest});
    assign a32 = wide ? a32_16 : a32_8;
    under unit (clock, rest[48 +: 96], rest[16 +: 32], rest[144 +: 96], a32, rest[0 +: 16],
        colours, transmittance, ended);

    always @(negedge clock) if (!done) begin
        edges = edges + 1;
        `EXPECT(2, "a32", -1, `under_a32, a32);
        `EXPECT(3, "lost", -1, `under_lost, unit.lost);
        for (i = 0; i < 3; i = i + 1) begin
            `EXPECT(3, "part", i, `under_part0_top - 32 * i -: 32, unit.gained[32*i +: 32]);
            `EXPECT(4, "en", i, `under_en0_top - 32 * i -: 32, colours[32*i +: 32]);
        end
        `EXPECT(4, "tn", -1, `under_tn, transmittance);
        `EXPECT(4, "ended", -1, `under_ended, ended);
        finish_after(4);
    end
endmodule
