// The stage pixel: a pixel's channels to the formats of displays, SPEC.md, section 17.
`default_nettype none
`include "layout.vh"

module bench_pixel (
    output reg done
);
    localparam STAGE = "pixel";
    localparam ROWS = `pixel_ROWS;
    localparam BITS = `pixel_BITS;
`include "bench.vh"

    wire [31:0] levels;
    wire [15:0] rgb565;
    wire [7:0]  l8;
    wire [3:0]  grey4;
    wire        mono;

    pixel unit (clock, {row[`pixel_channel3], row[`pixel_channel2], row[`pixel_channel1],
        row[`pixel_channel0]}, row[`pixel_x_top-13 -: 3], row[`pixel_y_top-13 -: 3], levels, rgb565,
        l8, grey4, mono);

    always @(negedge clock) if (!done) begin
        edges = edges + 1;
        `EXPECT(1, "threshold", -1, `pixel_threshold, unit.threshold);
        `EXPECT(1, "grey", -1, `pixel_grey, unit.grey);
        `EXPECT(3, "rgba8888", -1, `pixel_rgba8888, levels);
        `EXPECT(3, "bgra8888", -1, `pixel_bgra8888,
            {levels[15:8], levels[23:16], levels[31:24], levels[7:0]});
        `EXPECT(3, "rgb888", -1, `pixel_rgb888, levels[31:8]);
        `EXPECT(3, "rgb565_le", -1, `pixel_rgb565_le, {rgb565[7:0], rgb565[15:8]});
        `EXPECT(3, "rgb565_be", -1, `pixel_rgb565_be, rgb565);
        `EXPECT(3, "l8", -1, `pixel_l8, l8);
        `EXPECT(3, "grey4", -1, `pixel_grey4, grey4);
        `EXPECT(3, "mono", -1, `pixel_mono, mono);
        finish_after(3);
    end
endmodule
