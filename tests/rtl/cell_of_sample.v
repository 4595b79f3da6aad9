// The cell of sample k on one axis, SPEC.md, section 10, and the two indices times the stride,
// section 3. One sample a clock, 4 clocks late.
`default_nettype none

module cell_of_sample (
    input  wire        clock,
    input  wire [63:0] place,    // s64.32, of sample 0
    input  wire [63:0] advance,  // s64.32
    input  wire [22:0] k,        // s23, -2^22 .. 2^22 - 1
    input  wire [12:0] size,     // n, 1 .. 4096
    input  wire [31:0] stride,   // t, s32, bytes
    output wire [11:0] i0, i1,   // 0 .. n - 1
    output wire [7:0]  f,        // u8.8
    output wire [43:0] offset0,  // s44: i0 t
    output wire [43:0] offset1   // s44: i1 t
);
    // Clocks 1 and 2: P. All modulo 2^64; P itself is -2^31 + 2^23 .. n 2^32 - 1.
    localparam [63:0] CENTRE = 64'd8388608 - 64'd2147483648; // 1/512 voxel less 1/2 voxel

    wire [63:0] way, moved, point;
    wire [12:0] size2;

    scale_signed #(.A(64), .B(23), .P(64)) mul_way (clock, advance, k, way);
    add #(.WIDTH(64)) add_moved (clock, place, CENTRE, moved);
    add #(.WIDTH(64)) add_point (clock, moved, way, point);
    delay #(.WIDTH(13), .CLOCKS(2)) delay_size (clock, size, size2);

    // Clock 3: clamp(i, 0, n - 1) and clamp(i + 1, 0, n - 1). i is -1 .. n - 1: bit 44 of the
    // point is its sign.
    reg  [11:0] low, high;
    reg  [7:0]  fraction;
    wire        negative = point[44];
    wire [12:0] next = {1'b0, point[43:32]} + 13'd1;
    wire [31:0] stride3;

    always @(posedge clock) begin
        low      <= negative ? 12'd0 : point[43:32];
        high     <= negative ? 12'd0 : next == size2 ? point[43:32] : next[11:0];
        fraction <= point[31:24];
    end
    delay #(.WIDTH(32), .CLOCKS(3)) delay_stride (clock, stride, stride3);

    // Clock 4: bytes from index 0.
    scale_signed #(.A(32), .B(13), .P(44)) mul_low (clock, stride3, {1'b0, low}, offset0);
    scale_signed #(.A(32), .B(13), .P(44)) mul_high (clock, stride3, {1'b0, high}, offset1);
    delay #(.WIDTH(32)) delay_cell (clock, {low, high, fraction}, {i0, i1, f});
endmodule
