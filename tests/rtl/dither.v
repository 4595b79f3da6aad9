// A channel on 0 .. TOP, dithered, SPEC.md, section 17. One channel a clock, 2 clocks late.
`default_nettype none

module dither #(
    parameter [5:0] TOP = 31
) (
    input  wire        clock,
    input  wire [23:0] value,     // u24.16, at most 0x00FF0000
    input  wire [5:0]  threshold, // t
    output reg  [5:0]  level      // 0 .. TOP
);
    // v TOP + 130560 (2 t + 1), below 2^31. Only what lies above 2^16 counts: dividing by
    // 255 * 2^16 and cutting is cutting 16 bits, then dividing by 255 and cutting.
    reg  [14:0] upper;
    wire [30:0] sum = {7'd0, value} * {25'd0, TOP} + 31'd130560 * {24'd0, threshold, 1'b1};
    // floor(m / 255) = floor((m + 1 + floor(m / 256)) / 256) for m below 65535
    wire [15:0] quotient = {1'b0, upper} + 16'd1 + {9'd0, upper[14:8]};

    always @(posedge clock) begin
        upper <= sum[30:16];
        level <= quotient[13:8];
    end
endmodule
