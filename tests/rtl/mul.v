// product = a * b + ROUND, unsigned, with a register behind it. ROUND enters as one more row of
// partial products, the way a DSP block preloads its accumulator: it is no adder of its own.
`default_nettype none

module mul #(
    parameter A = 8,
    parameter B = 8,
    parameter [A+B-1:0] ROUND = 0
) (
    input  wire           clock,
    input  wire [A-1:0]   a,
    input  wire [B-1:0]   b,
    output reg  [A+B-1:0] product
);
    wire [A+B-1:0] exact;

    // The widths on both sides are those of the product, so that nothing is lost.
    assign exact = {{B{1'b0}}, a} * {{A{1'b0}}, b};

    generate
        if (ROUND == 0) begin : cut
            always @(posedge clock) product <= exact;
        end else begin : rounded
            always @(posedge clock) product <= exact + ROUND;
        end
    endgenerate
endmodule
