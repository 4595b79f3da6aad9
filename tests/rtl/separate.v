// Separate interpolation of eight RGBA voxels of 8 or 16 bits, SPEC.md, sections 11 and 12: 36
// multipliers and 47 adders as interpolate.v, and 3 multipliers for the lights. One sample a
// clock, 9 clocks late.
`default_nettype none

module separate #(
    parameter BITS = 8 // of a channel: 8 or 16
) (
    input  wire                clock,
    input  wire [7:0]          fx, fy, fz,  // u8.8, the place in the cell
    input  wire [8*BITS-1:0]   opacities,   // A[q] in bits BITS (q + 1) - 1 to BITS q
    input  wire [3*8*BITS-1:0] colours,     // K[c][q], number 8 c + q, likewise
    output wire [BITS+15:0]    opacity,     // O, at most 65536 (2^BITS - 1)
    output wire [95:0]         lights,      // L[c] in bits 32 c + 31 to 32 c
    output wire                skipped      // all eight opacities are 0
);
    localparam S = BITS + 16;    // bits of a sum: at most 65536 (2^BITS - 1)
    localparam SHIFT = 16 - BITS; // of both factors of a light

    genvar q, c;

    // Clock 4: the weights. Number 3 of the channels is the opacity.
    wire [8*17-1:0]     w;
    wire [4*8*BITS-1:0] channels4;
    wire                none4 = channels4[3*8*BITS +: 8*BITS] == 0;

    weights weigh (clock, fx, fy, fz, w);
    delay #(.WIDTH(32*BITS), .CLOCKS(4)) delay_channels (clock, {opacities, colours}, channels4);

    // Clock 5: the terms. Clock 8: their sums.
    wire [4*8*S-1:0] terms;
    wire [4*S-1:0]   sums; // D[c] and O

    generate
        for (c = 0; c < 4; c = c + 1) begin : channel
            for (q = 0; q < 8; q = q + 1) begin : corner
                wire [BITS+16:0] product; // its bit BITS + 16 is 0, as in interpolate.v

                mul #(.A(17), .B(BITS)) multiplier (clock, w[17*q +: 17],
                    channels4[BITS*(8*c+q) +: BITS], product);
                assign terms[S*(8*c+q) +: S] = product[S-1:0];
            end
            sum8 #(.WIDTH(S)) add_terms (clock, terms[8*S*c +: 8*S], sums[S*c +: S]);
        end
    endgenerate

    // Clock 9: colour times opacity.
    wire [31:0] opacity8 = {{SHIFT{1'b0}}, sums[3*S +: S]} << SHIFT;

    generate
        for (c = 0; c < 3; c = c + 1) begin : light
            wire [31:0] colour = {{SHIFT{1'b0}}, sums[c*S +: S]} << SHIFT;

            hi multiplier (clock, colour, opacity8, lights[32*c +: 32]);
        end
    endgenerate
    delay #(.WIDTH(S)) delay_opacity (clock, sums[3*S +: S], opacity);
    delay #(.WIDTH(1), .CLOCKS(5)) delay_skipped (clock, none4, skipped);
endmodule
