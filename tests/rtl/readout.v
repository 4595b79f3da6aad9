// The channels of a pixel from the light of its ray, SPEC.md, section 16. One pixel a clock, 4
// clocks late.
`default_nettype none

module readout (
    input  wire        clock,
    input  wire [95:0] colours,       // E[c] in bits 32 c + 31 to 32 c
    input  wire [31:0] transmittance, // T, u32.31
    input  wire [99:0] background,    // G[c], u25.17, in bits 25 c + 24 to 25 c, c = 0 .. 3
    input  wire [31:0] factor,        // readout of section 16, by the storage
    output wire [95:0] channels       // u24.16, channel c in bits 24 c + 23 to 24 c, c = 0 .. 3
);
    localparam [31:0] FULL31 = 32'h01FE0000; // 255 * 2^17
    localparam [31:0] FULL16 = 32'h00FF0000; // 255 * 2^16, 1

    // Clock 1: light, background and what is missing to opacity, each at most 2^24.
    wire [31:0] missing, behind;

    hi hi_missing (clock, transmittance, FULL31, missing);
    hi hi_behind (clock, transmittance, {7'd0, background[99:75]}, behind);

    // Clock 2: 1 - T. Clock 3: the opacity, which has that of the background.
    wire [31:0] covered, behind2, opacity3;

    sub #(.WIDTH(32)) sub_covered (clock, FULL16, missing, covered);
    delay #(.WIDTH(32)) delay_behind (clock, behind, behind2);
    add #(.WIDTH(32)) add_opacity (clock, covered, behind2, opacity3);

    // Clock 4: no colour above the opacity.
    genvar c;

    generate
        for (c = 0; c < 3; c = c + 1) begin : channel
            wire [31:0] own, back, sum, sum3;
            reg  [23:0] limited;

            hi hi_own (clock, colours[32*c +: 32], factor, own);
            hi hi_back (clock, transmittance, {7'd0, background[25*c +: 25]}, back);
            add #(.WIDTH(32)) add_sum (clock, own, back, sum);
            delay #(.WIDTH(32)) delay_sum (clock, sum, sum3);
            always @(posedge clock) limited <= sum3 < opacity3 ? sum3[23:0] : opacity3[23:0];
            assign channels[24*c +: 24] = limited;
        end
    endgenerate
    delay #(.WIDTH(24)) delay_opacity (clock, opacity3[23:0], channels[72 +: 24]);
endmodule
