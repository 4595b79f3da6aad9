// The stage readout: light and background to a pixel's channels, SPEC.md, section 16.
`default_nettype none
`include "layout.vh"

module bench_readout (
    output reg done
);
    localparam STAGE = "readout";
    localparam ROWS = `readout_ROWS;
    localparam BITS = `readout_BITS;
`include "bench.vh"

    // The weighted background comes 4 clocks late, and with it the rest of the row.
    wire [99:0]  weighted;
    wire [95:0]  channels;
    wire [129:0] rest;
    reg  [31:0]  factor;

    background behind (clock, {row[`readout_background3], row[`readout_background2],
        row[`readout_background1], row[`readout_background0]}, weighted);
    delay #(.WIDTH(130), .CLOCKS(4)) delay_rest (clock, {row[`readout_kind_top-2 -: 2],
        row[`readout_e2], row[`readout_e1], row[`readout_e0], row[`readout_t]}, rest);
    always @*
        case (rest[129:128])
            2'd0: factor = 32'd33686018; // 8-bit storage
            2'd1: factor = 32'd33424380; // 16-bit storage
            2'd2: factor = 32'd66847740; // extinction of stored opacity
            2'd3: factor = 32'd33554432; // associated8
        endcase
    readout unit (clock, rest[127:32], rest[31:0], weighted, factor, channels);

    always @(negedge clock) if (!done) begin
        edges = edges + 1;
        `EXPECT(1, "p", 0, `readout_p0, behind.channel[0].p);
        `EXPECT(1, "p", 1, `readout_p1, behind.channel[1].p);
        `EXPECT(1, "p", 2, `readout_p2, behind.channel[2].p);
        `EXPECT(1, "p", 3, `readout_p3, behind.channel[3].p);
        for (i = 0; i < 4; i = i + 1) begin
            `EXPECT(4, "g", i, `readout_g0_top - 32 * i -: 32, weighted[25*i +: 25]);
            `EXPECT(8, "channel", i, `readout_channel0_top - 32 * i -: 32, channels[24*i +: 24]);
        end
        finish_after(8);
    end
endmodule
