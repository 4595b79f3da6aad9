// upper = hi(a, b) of SPEC.md, section 2: the upper half of a product of 32 bits, rounded.
`default_nettype none

module hi (
    input  wire        clock,
    input  wire [31:0] a,
    input  wire [31:0] b,
    output wire [31:0] upper
);
    wire [63:0] product; // at most (2^32 - 1)^2 + 2^31 < 2^64

    mul #(.A(32), .B(32), .ROUND(64'h80000000)) multiplier (clock, a, b, product);
    assign upper = product[63:32];
endmodule
