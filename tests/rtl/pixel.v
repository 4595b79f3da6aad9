// The pixel formats of SPEC.md, section 17, all at once. One pixel a clock, 3 clocks late.
`default_nettype none

module pixel (
    input  wire        clock,
    input  wire [95:0] channels, // u24.16, channel c in bits 24 c + 23 to 24 c, c = 0 .. 3
    input  wire [2:0]  x, y,     // the absolute position modulo 8
    output wire [31:0] levels,   // level8 of channels 0, 1, 2, 3, the first highest
    output wire [15:0] rgb565,
    output wire [7:0]  l8,
    output wire [3:0]  grey4,
    output wire        mono
);
    // Clock 1: grey, the levels, and the threshold of the dither.
    reg  [71:0] channels1;
    reg  [23:0] grey;
    reg  [31:0] levels1;
    reg  [5:0]  threshold;
    wire [31:0] grey_sum = 32'd77 * {8'd0, channels[23:0]} + 32'd150 * {8'd0, channels[47:24]}
        + 32'd29 * {8'd0, channels[71:48]} + 32'd128; // 256 * 0x00FF0000 + 128 < 2^32
    genvar      c;

    always @(posedge clock) begin
        channels1 <= channels[71:0];
        grey      <= grey_sum[31:8];
        threshold <= {x[0] ^ y[0], y[0], x[1] ^ y[1], y[1], x[2] ^ y[2], y[2]};
    end
    generate
        for (c = 0; c < 4; c = c + 1) begin : level
            always @(posedge clock)
                levels1[24-8*c +: 8] <= channels[24*c+16 +: 8] + {7'd0, channels[24*c+15]};
        end
    endgenerate

    // Clocks 2 and 3: five ditherings with one threshold.
    wire [5:0] red, green, blue, grey_4, grey_1;

    dither #(.TOP(31)) dither_red (clock, channels1[23:0], threshold, red);
    dither #(.TOP(63)) dither_green (clock, channels1[47:24], threshold, green);
    dither #(.TOP(31)) dither_blue (clock, channels1[71:48], threshold, blue);
    dither #(.TOP(15)) dither_grey4 (clock, grey, threshold, grey_4);
    dither #(.TOP(1)) dither_mono (clock, grey, threshold, grey_1);
    assign rgb565 = {red[4:0], green, blue[4:0]};
    assign grey4 = grey_4[3:0];
    assign mono = grey_1[0];

    delay #(.WIDTH(32), .CLOCKS(2)) delay_levels (clock, levels1, levels);
    delay #(.WIDTH(8), .CLOCKS(2)) delay_l8 (clock, grey[23:16] + {7'd0, grey[15]}, l8);
endmodule
