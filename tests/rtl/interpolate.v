// Opacity-weighted interpolation of eight RGBA voxels of 8 or 16 bits, SPEC.md, sections 11 and
// 12: 36 multipliers, 47 adders. One sample a clock, 9 clocks late.
//
// The eight weights times the eight opacities are the weighted weights s. Their sum is the
// opacity, and their products with the colours sum to the lights. So a colour counts as much as
// its voxel is opaque, and a transparent voxel's colour does not count.
`default_nettype none

module interpolate #(
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
    localparam S = BITS + 16;               // bits of a weighted weight: at most 65536 (2^BITS - 1)
    localparam CUT = BITS == 16 ? 16 : 0;   // bits that a term of a light loses

    genvar q, c;

    // Clock 4: the weights.
    wire [8*17-1:0]     w;
    wire [8*BITS-1:0]   opacities4;
    wire [3*8*BITS-1:0] colours5;
    wire                none4;

    weights weigh (clock, fx, fy, fz, w);
    delay #(.WIDTH(8*BITS), .CLOCKS(4)) delay_opacities (clock, opacities, opacities4);
    delay #(.WIDTH(24*BITS), .CLOCKS(5)) delay_colours (clock, colours, colours5);

    // Clock 5: the weighted weights. A weight of 65536 fills bit 16, and then s has its bit
    // BITS + 15 at most: the upper bit of the product stays 0.
    wire [8*S-1:0] s;

    generate
        for (q = 0; q < 8; q = q + 1) begin : corner
            wire [BITS+16:0] product;

            mul #(.A(17), .B(BITS)) multiplier (clock, w[17*q +: 17], opacities4[BITS*q +: BITS],
                product);
            assign s[S*q +: S] = product[S-1:0];
        end
    endgenerate

    // Clock 8: the opacity.
    wire [S-1:0] opacity8;

    sum8 #(.WIDTH(S)) sum_opacity (clock, s, opacity8);
    delay #(.WIDTH(S)) delay_opacity (clock, opacity8, opacity);

    // Clock 6: the terms of the lights; clock 9: their sums, at most 65536 * 255^2 or 65535^2.
    wire [3*8*32-1:0] terms;

    generate
        for (c = 0; c < 3; c = c + 1) begin : channel
            for (q = 0; q < 8; q = q + 1) begin : corner
                wire [S+BITS-1:0] product;

                mul #(.A(S), .B(BITS)) multiplier (clock, s[S*q +: S],
                    colours5[BITS*(8*c+q) +: BITS], product);
                assign terms[32*(8*c+q) +: 32] = product[S+BITS-1:CUT];
            end
            sum8 #(.WIDTH(32)) sum_light (clock, terms[256*c +: 256], lights[32*c +: 32]);
        end
    endgenerate

    assign none4 = opacities4 == 0;
    delay #(.WIDTH(1), .CLOCKS(5)) delay_skipped (clock, none4, skipped);
endmodule
