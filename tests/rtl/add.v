// sum = a + b modulo 2^WIDTH, with a register behind it.
`default_nettype none

module add #(
    parameter WIDTH = 32
) (
    input  wire             clock,
    input  wire [WIDTH-1:0] a,
    input  wire [WIDTH-1:0] b,
    output reg  [WIDTH-1:0] sum
);
    wire [WIDTH-1:0] result;

    assign result = a + b;
    always @(posedge clock) sum <= result;
endmodule
