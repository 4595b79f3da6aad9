// The stages transmittance and transmittance16: exp by table, SPEC.md, section 27.
`default_nettype none
`include "layout.vh"

module bench_transmittance (
    output reg done
);
    localparam STAGE = "transmittance";
    localparam ROWS = `transmittance_ROWS;
    localparam BITS = `transmittance_BITS;
`include "bench.vh"

    wire [31:0] t, opacity;

    transmittance unit (clock, row[`transmittance_x], t, opacity);

    // Column w is wider than what the unit keeps of it.
    always @(negedge clock) if (!done) begin
        edges = edges + 1;
        `EXPECT(1, "g", -1, `transmittance_g, unit.g);
        `EXPECT(1, "index", -1, `transmittance_index, unit.g[31:26]);
        `EXPECT(1, "place", -1, `transmittance_place, unit.t);
        `EXPECT(2, "base", -1, `transmittance_base, unit.b);
        `EXPECT(10, "t", -1, `transmittance_t, t);
        `EXPECT(11, "opacity", -1, `transmittance_opacity, opacity);
        finish_after(11);
    end
endmodule

module bench_transmittance16 (
    output reg done
);
    localparam STAGE = "transmittance16";
    localparam ROWS = `transmittance16_ROWS;
    localparam BITS = `transmittance16_BITS;
`include "bench.vh"

    wire [15:0] t16, opacity16;

    transmittance16 unit (clock, row[`transmittance16_x], t16, opacity16);

    always @(negedge clock) if (!done) begin
        edges = edges + 1;
        `EXPECT(1, "w", -1, `transmittance16_w, unit.whole);
        `EXPECT(1, "g", -1, `transmittance16_g, unit.g);
        `EXPECT(1, "place", -1, `transmittance16_place, unit.g[17:2]);
        `EXPECT(2, "base", -1, `transmittance16_base, unit.b);
        `EXPECT(10, "t16", -1, `transmittance16_t16, t16);
        `EXPECT(11, "opacity16", -1, `transmittance16_opacity16, opacity16);
        finish_after(11);
    end
endmodule
