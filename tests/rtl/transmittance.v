// The transmittance 2^-x of a depth x, SPEC.md, section 27, wide: a table of 64 powers of two and
// a cubic between them. 4 multipliers, 6 adders, a shifter of 32 bits. One depth a clock, 10
// clocks late, its opacity 11.
`default_nettype none

module transmittance #(
    parameter TABLE = "tests/rtl/exp_power.hex"
) (
    input  wire        clock,
    input  wire [63:0] depth, // x, u64.32
    output reg  [31:0] t31,   // T(x), u32.31
    output wire [31:0] opacity // 2^31 - T(x), one clock later
);
    // exp_power[i] = round(2^(31 + i/64)), u32.31
    reg [31:0] exp_power [0:63];

    initial $readmemh(TABLE, exp_power);

    // Clock 1: g, the depth up to the next whole number; the whole part goes to the shifter.
    wire [31:0] g;
    wire [5:0]  whole; // 32 stands for all from there on

    sub #(.WIDTH(32)) negate (clock, 32'd0, depth[31:0], g);
    delay #(.WIDTH(6)) delay_whole (clock, {|depth[63:37], depth[36:32]}, whole);

    // Clock 2: table, and the cubic term of t, the place between two entries.
    reg  [31:0] b;
    wire [31:0] t = {g[25:0], 6'd0}; // u32.32
    wire [31:0] cubic;

    always @(posedge clock) b <= exp_power[g[31:26]];
    mul #(.A(16), .B(16)) mul_cubic (clock, 16'hE494, t[31:16], cubic);

    // Clocks 3 to 6: r = 64 (2^(t/64) - 1), u32.32, by Horner's rule.
    wire [31:0] s, slope, gradient, r, t3, t5;

    delay #(.WIDTH(32), .CLOCKS(2)) delay_t3 (clock, t, t3);
    delay #(.WIDTH(32), .CLOCKS(2)) delay_t5 (clock, t3, t5);
    add #(.WIDTH(32)) add_s (clock, 32'h00F5FD31, {16'd0, cubic[31:16]}, s);
    hi hi_slope (clock, t3, s, slope);
    add #(.WIDTH(32)) add_gradient (clock, 32'hB1721819, slope, gradient);
    hi hi_r (clock, t5, gradient, r);

    // Clocks 7 and 8: the power of two, 2^31 to 2^32 - 1.
    wire [31:0] b6, b7, part, power;

    delay #(.WIDTH(32), .CLOCKS(4)) delay_b6 (clock, b, b6);
    delay #(.WIDTH(32)) delay_b7 (clock, b6, b7);
    hi hi_part (clock, b6, r, part);
    add #(.WIDTH(32)) add_power (clock, b7, {6'd0, part[31:6]}, power);

    // Clock 9: the shift. Clock 10: the last rounding. A whole depth, g = 0, is exact: it comes
    // from power = 2^31 without a shift by one more.
    wire [5:0]  whole8;
    wire        exact1, exact8;
    reg  [31:0] shifted;
    reg         exact, none;

    assign exact1 = g == 0;
    delay #(.WIDTH(6), .CLOCKS(7)) delay_whole8 (clock, whole, whole8);
    delay #(.WIDTH(1), .CLOCKS(7)) delay_exact (clock, exact1, exact8);
    always @(posedge clock) begin
        shifted <= power >> whole8[4:0];
        exact   <= exact8;
        none    <= whole8[5];
        t31     <= none ? 32'd0 : exact ? shifted : {1'b0, shifted[31:1]} + {31'd0, shifted[0]};
    end
    sub #(.WIDTH(32)) sub_opacity (clock, 32'h80000000, t31, opacity);
endmodule
