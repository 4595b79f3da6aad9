// The transmittance 2^-x of a depth x as unorm16, SPEC.md, section 27, 16 bits: a table of 64
// powers of two and a parabola between them. 4 multipliers, 8 adders, a shifter of 32 bits. One
// depth a clock, 10 clocks late, its opacity 11.
`default_nettype none

module transmittance16 #(
    parameter TABLE = "tests/rtl/exp_power.hex"
) (
    input  wire        clock,
    input  wire [31:0] depth, // x, u32.24
    output reg  [15:0] t16,   // T16(x), unorm16
    output wire [15:0] opacity // 65535 - T16(x), one clock later
);
    // exp_power[i] = round(2^(31 + i/64)), u32.31
    reg [31:0] exp_power [0:63];

    initial $readmemh(TABLE, exp_power);

    // Clock 1: g, the depth up to the next whole number.
    wire [23:0] g;
    wire [7:0]  whole;

    sub #(.WIDTH(24)) negate (clock, 24'd0, depth[23:0], g);
    delay #(.WIDTH(8)) delay_whole (clock, depth[31:24], whole);

    // Clock 2: table, its upper half rounded, and the products of t and of the two bits below.
    reg  [31:0] b;
    wire [31:0] square; // 0xF754 t
    wire [17:0] below;  // 0x2C7B (g mod 4)

    always @(posedge clock) b <= exp_power[g[23:18]];
    mul #(.A(16), .B(16)) mul_square (clock, 16'hF754, g[17:2], square);
    mul #(.A(16), .B(2)) mul_below (clock, 16'h2C7B, g[1:0], below);

    // Clocks 3 to 5: r = 64 (2^(t/64) - 1), u32.32.
    wire [31:0] gradient, r;
    wire [47:0] rise;
    wire [15:0] t3;
    wire [17:0] below4;

    delay #(.WIDTH(16), .CLOCKS(2)) delay_t3 (clock, g[17:2], t3);
    delay #(.WIDTH(18), .CLOCKS(2)) delay_below (clock, below, below4);
    add #(.WIDTH(32)) add_gradient (clock, 32'hB171A5D5, {8'd0, square[31:8]}, gradient);
    mul #(.A(32), .B(16)) mul_rise (clock, gradient, t3, rise);
    add #(.WIDTH(32)) add_r (clock, rise[47:16], {14'd0, below4}, r);

    // Clocks 6 and 7: the power of two, half of it, at most 2^31.
    wire [31:0] b5, b6, sum;
    wire [15:0] upper3, upper5; // at most 0xFD3F, no carry
    wire [47:0] part;

    delay #(.WIDTH(32), .CLOCKS(3)) delay_b5 (clock, b, b5);
    delay #(.WIDTH(32)) delay_b6 (clock, b5, b6);
    add #(.WIDTH(16)) add_upper (clock, b[31:16], {15'd0, b[15]}, upper3);
    delay #(.WIDTH(16), .CLOCKS(2)) delay_upper5 (clock, upper3, upper5);
    mul #(.A(32), .B(16)) mul_part (clock, r, upper5, part);
    add #(.WIDTH(32)) add_power (clock, b6, {6'd0, part[47:22]}, sum);

    // Clock 8: to 65535 as 1. Clock 9: the shift. Clock 10: the last rounding.
    wire        exact1, exact7;
    wire [31:0] p, q;
    wire [7:0]  whole8;
    reg  [17:0] shifted;
    reg         none;

    assign exact1 = g == 0;
    delay #(.WIDTH(1), .CLOCKS(6)) delay_exact (clock, exact1, exact7);
    delay #(.WIDTH(8), .CLOCKS(7)) delay_whole8 (clock, whole, whole8);
    assign p = exact7 ? 32'h80000000 : {1'b0, sum[31:1]};
    sub #(.WIDTH(32)) sub_q (clock, p, {16'd0, p[31:16]}, q);
    always @(posedge clock) begin
        shifted <= q[31:14] >> whole8[4:0];
        none    <= whole8 >= 8'd17;
        t16     <= none ? 16'd0 : shifted[16:1] + {15'd0, shifted[0]};
    end
    sub #(.WIDTH(16)) sub_opacity (clock, 16'hFFFF, t16, opacity);
endmodule
