// The eight trilinear weights of a cell, SPEC.md, section 11: 4 multipliers, 19 adders, and the
// rounding of xyz within its multiplier. One cell a clock, 4 clocks late.
//
// Sums wrap modulo 2^17 on the way. The results do not: each is 0 .. 65536.
`default_nettype none

module weights (
    input  wire           clock,
    input  wire [7:0]     fx, fy, fz, // u8.8
    output wire [8*17-1:0] w          // w[q], u17.16, in bits 17 q + 16 to 17 q
);
    // Clock 1: products of two, at most 255^2, and the part of w[0] that needs no product.
    wire [15:0] xy, xz, yz;
    wire [16:0] x_y, one_z;

    mul #(.A(8), .B(8)) mul_xy (clock, fx, fy, xy);
    mul #(.A(8), .B(8)) mul_xz (clock, fx, fz, xz);
    mul #(.A(8), .B(8)) mul_yz (clock, fy, fz, yz);
    add #(.WIDTH(17)) add_x_y (clock, {1'b0, fx, 8'b0}, {1'b0, fy, 8'b0}, x_y);
    sub #(.WIDTH(17)) sub_one_z (clock, 17'h10000, {1'b0, fz, 8'b0}, one_z);

    // Clock 2: the product of three, and sums of two products.
    wire [7:0]  fz1;
    wire [23:0] xyz_product; // 255^3 + 128 < 2^24
    wire [15:0] xyz = xyz_product[23:8];
    wire [16:0] xy_xz, xy_yz, xz_yz, base, rest;

    delay #(.WIDTH(8)) delay_fz1 (clock, fz, fz1);
    mul #(.A(16), .B(8), .ROUND(24'd128)) mul_xyz (clock, xy, fz1, xyz_product);
    add #(.WIDTH(17)) add_xy_xz (clock, {1'b0, xy}, {1'b0, xz}, xy_xz);
    add #(.WIDTH(17)) add_xy_yz (clock, {1'b0, xy}, {1'b0, yz}, xy_yz);
    add #(.WIDTH(17)) add_xz_yz (clock, {1'b0, xz}, {1'b0, yz}, xz_yz);
    add #(.WIDTH(17)) add_base (clock, one_z, {1'b0, xz}, base);
    sub #(.WIDTH(17)) sub_rest (clock, {1'b0, xy}, x_y, rest);

    // Clock 3: all that needs xyz once.
    wire [7:0]  fx2, fy2, fz2;
    wire [15:0] xy2, xz2, yz2;
    wire [16:0] x_xyz, y_xyz, z_xyz, xy_xyz, xz_xyz, yz_xyz, base_xyz, rest_yz;

    delay #(.WIDTH(16), .CLOCKS(2)) delay_fx2 (clock, {fx, fy}, {fx2, fy2});
    delay #(.WIDTH(8)) delay_fz2 (clock, fz1, fz2);
    delay #(.WIDTH(48)) delay_products (clock, {xy, xz, yz}, {xy2, xz2, yz2});
    add #(.WIDTH(17)) add_x_xyz (clock, {1'b0, fx2, 8'b0}, {1'b0, xyz}, x_xyz);
    add #(.WIDTH(17)) add_y_xyz (clock, {1'b0, fy2, 8'b0}, {1'b0, xyz}, y_xyz);
    add #(.WIDTH(17)) add_z_xyz (clock, {1'b0, fz2, 8'b0}, {1'b0, xyz}, z_xyz);
    sub #(.WIDTH(17)) sub_xy_xyz (clock, {1'b0, xy2}, {1'b0, xyz}, xy_xyz);
    sub #(.WIDTH(17)) sub_xz_xyz (clock, {1'b0, xz2}, {1'b0, xyz}, xz_xyz);
    sub #(.WIDTH(17)) sub_yz_xyz (clock, {1'b0, yz2}, {1'b0, xyz}, yz_xyz);
    sub #(.WIDTH(17)) sub_base_xyz (clock, base, {1'b0, xyz}, base_xyz);
    add #(.WIDTH(17)) add_rest_yz (clock, rest, {1'b0, yz2}, rest_yz);

    // Clock 4: the weights.
    wire [15:0] xyz3;
    wire [16:0] xy_xz3, xy_yz3, xz_yz3;

    delay #(.WIDTH(16)) delay_xyz (clock, xyz, xyz3);
    delay #(.WIDTH(51)) delay_sums (clock, {xy_xz, xy_yz, xz_yz}, {xy_xz3, xy_yz3, xz_yz3});
    add #(.WIDTH(17)) add_w0 (clock, base_xyz, rest_yz, w[17*0 +: 17]);
    sub #(.WIDTH(17)) sub_w1 (clock, x_xyz, xy_xz3, w[17*1 +: 17]);
    sub #(.WIDTH(17)) sub_w2 (clock, y_xyz, xy_yz3, w[17*2 +: 17]);
    delay #(.WIDTH(17)) delay_w3 (clock, xy_xyz, w[17*3 +: 17]);
    sub #(.WIDTH(17)) sub_w4 (clock, z_xyz, xz_yz3, w[17*4 +: 17]);
    delay #(.WIDTH(17)) delay_w5 (clock, xz_xyz, w[17*5 +: 17]);
    delay #(.WIDTH(17)) delay_w6 (clock, yz_xyz, w[17*6 +: 17]);
    delay #(.WIDTH(17)) delay_w7 (clock, {1'b0, xyz3}, w[17*7 +: 17]);
endmodule
