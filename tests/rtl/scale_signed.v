// product = a * b modulo 2^P, signed, with a register behind it.
`default_nettype none

module scale_signed #(
    parameter A = 64,
    parameter B = 23,
    parameter P = 64
) (
    input  wire         clock,
    input  wire [A-1:0] a,
    input  wire [B-1:0] b,
    output reg  [P-1:0] product
);
    wire [P-1:0] exact;

    assign exact = {{P-A{a[A-1]}}, a} * {{P-B{b[B-1]}}, b};
    always @(posedge clock) product <= exact;
endmodule
