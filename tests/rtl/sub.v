// difference = a - b modulo 2^WIDTH, with a register behind it. It counts as an adder.
`default_nettype none

module sub #(
    parameter WIDTH = 32
) (
    input  wire             clock,
    input  wire [WIDTH-1:0] a,
    input  wire [WIDTH-1:0] b,
    output reg  [WIDTH-1:0] difference
);
    wire [WIDTH-1:0] result;

    assign result = a - b;
    always @(posedge clock) difference <= result;
endmodule
