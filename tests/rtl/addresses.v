// The cell of a sample and the addresses of its eight corners, SPEC.md, sections 3 and 10. One
// sample a clock; the place in the cell is 4, the addresses are 6 clocks late.
`default_nettype none

module addresses (
    input  wire          clock,
    input  wire [3*13-1:0] size,    // n[a] in bits 13 a + 12 to 13 a, 1 .. 4096
    input  wire [95:0]   stride,  // t[a], s32, likewise
    input  wire [191:0]  place,   // s64.32
    input  wire [191:0]  advance, // s64.32
    input  wire [22:0]   k,       // s23
    output wire [23:0]   f,       // u8.8
    // s46: bytes from voxel (0, 0, 0) to corner q in 46 q + 45 to 46 q
    output wire [8*46-1:0] address
);
    // i t has 12 + 32 bits with its sign; the sum of three has two more.
    wire [71:0]   index; // i1 and i0 of the axes
    wire [6*46-1:0] offset; // number 2 a + 1 is that of i1, 2 a that of i0
    genvar        a, q;

    generate
        for (a = 0; a < 3; a = a + 1) begin : axis
            wire [43:0] offset0, offset1;

            cell_of_sample one (clock, place[64*a +: 64], advance[64*a +: 64], k,
                size[13*a +: 13], stride[32*a +: 32], index[24*a +: 12], index[24*a+12 +: 12],
                f[8*a +: 8], offset0, offset1);
            assign offset[92*a +: 46] = {{2{offset0[43]}}, offset0};
            assign offset[92*a+46 +: 46] = {{2{offset1[43]}}, offset1};
        end
    endgenerate

    // Clock 5: the four sums of x and y. Clock 6: with z.
    wire [4*46-1:0] plane;
    wire [91:0]     offset_z;

    delay #(.WIDTH(92)) delay_z (clock, offset[4*46 +: 92], offset_z);
    generate
        for (q = 0; q < 4; q = q + 1) begin : edge_of_z
            add #(.WIDTH(46)) adder (clock, offset[46*(q%2) +: 46], offset[46*(2+q/2) +: 46],
                plane[46*q +: 46]);
        end
        for (q = 0; q < 8; q = q + 1) begin : corner
            add #(.WIDTH(46)) adder (clock, plane[46*(q%4) +: 46], offset_z[46*(q/4) +: 46],
                address[46*q +: 46]);
        end
    endgenerate
endmodule
